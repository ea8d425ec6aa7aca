// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/edit/root_motion.hpp>
#include <orispline/edit/up_axis.hpp>

#include "edit/moving_clips.hpp"

namespace orispline { namespace {

using namespace testing_support;

const Eigen::Vector3d up = Eigen::Vector3d::UnitY();

/// The hips below an armature that lies on its back and is a hundredth as large, as exporters write it.
Skeleton below_armature() {
  return Skeleton::make({{.name = "armature",
                          .rest = {.translation = {0.3, 0.0, 0.2},
                                   .rotation = turned(-1.5707963267948966, 0.0, 0.0),
                                   .scale = {0.01, 0.01, 0.01}}},
                         {.name = "hips", .parent = 0},
                         {.name = "leg", .parent = 1, .rest = {.translation = {0.0, -50.0, 0.0}}}})
      .value();
}

/// The walk in the frame of the armature.
Clip walk_below() {
  Clip clip = walk(1.0, 0.0, 0.4);
  const Eigen::Quaterniond back = turned(1.5707963267948966, 0.0, 0.0);
  for (Eigen::Quaterniond& q : clip.rotations[0].values) q = back * q;
  for (Eigen::Vector3d& v : clip.translations[0].values) v = 100.0 * (back * v);
  for (RotationChannel& channel : clip.rotations) channel.joint += 1;
  clip.translations[0].joint = 1;
  return clip;
}

TEST(RootMotion, GoesIntoTheNodeAboveAndLeavesTheWorldAsItWas) {
  const Skeleton skeleton = below_armature();
  const Clip clip = walk_below();
  const Clip moved = with_root_motion(skeleton, clip, {.joint = 1, .node = 0}).value();
  EXPECT_TRUE(check_clip(skeleton, moved));
  const ClipMotion was(skeleton, clip), is(skeleton, moved);
  for (const double t : clip.rotations[0].times)
    for (const std::size_t joint : {1u, 2u})
      EXPECT_TRUE(is.world_pose(joint, t).matrix().isApprox(was.world_pose(joint, t).matrix(), 1e-9)) << t;
  // The node has the whole way, the hips below it none.
  const Eigen::Affine3d start = is.world_pose(0, 0.0), end = is.world_pose(0, 1.0);
  const double heading =
      heading_of(up, Eigen::Quaterniond((end.linear() * start.linear().inverse()).eval()).normalized());
  EXPECT_NEAR(heading, 0.4, 1e-9);
  const auto below = [&](double t) {
    return Eigen::Vector3d(is.local_pose(1, t).translation - is.local_pose(1, 0.0).translation);
  };
  for (const double t : clip.rotations[0].times)
    EXPECT_NEAR(std::hypot(below(t).x(), below(t).y()), 0.0, 1e-7) << "up is z there";
}

TEST(RootMotion, InPlaceIsTakenOut) {
  const Skeleton skeleton = two_joints();
  const Clip clip = walk(1.0, 0.0, 0.4);
  const Clip here = with_root_motion(skeleton, clip, {.joint = 0}).value();
  const ClipMotion was(skeleton, clip), is(skeleton, here);
  for (const double t : clip.rotations[0].times) {
    const Eigen::Affine3d before = was.world_pose(0, t), now = is.world_pose(0, t), start = was.world_pose(0, 0.0);
    EXPECT_NEAR(now.translation().x(), start.translation().x(), 1e-12);
    EXPECT_NEAR(now.translation().z(), start.translation().z(), 1e-12);
    EXPECT_NEAR(now.translation().y(), before.translation().y(), 1e-12);
    EXPECT_NEAR(heading_of(up, Eigen::Quaterniond((now.linear() * start.linear().inverse()).eval())), 0.0, 1e-9);
    EXPECT_LE(angular_distance(is.local_pose(1, t).rotation, was.local_pose(1, t).rotation), 0.0);
  }
}

TEST(RootMotion, OfCubicsHasKeysWhereStraightLinesWouldBeOff) {
  const Skeleton skeleton = two_joints();
  RotationChannel turns = random_rotations(4, ChannelInterpolation::cubicspline, 0.5);
  turns.joint = 0;
  const Clip clip{
      .name = "cubic", .rotations = {turns}, .translations = {random_vectors(4, ChannelInterpolation::cubicspline)}};
  const Clip here = with_root_motion(skeleton, clip, {.joint = 0}).value();
  EXPECT_GT(here.rotations[0].size(), turns.size());
  const ClipMotion is(skeleton, here);
  const Eigen::Vector3d start = is.world_pose(0, clip.domain().start).translation();
  for (int k = 0; k <= 200; ++k) {
    const double t = clip.domain().start + k / 200.0 * (clip.domain().end - clip.domain().start);
    EXPECT_NEAR(is.world_pose(0, t).translation().x(), start.x(), 1e-9);
  }
}

TEST(RootMotion, HoldsBetweenLinearKeys) {
  RotationChannel turns{.joint = 1, .times = {0.0, 1.0}};
  turns.values = {turned(0.7, 0.0, 0.0), turned(0.0, 3.0, 0.0) * turned(-0.7, 0.0, 0.0)};
  const std::vector<Eigen::Vector3d> places{{0.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, {3.0, 1.5, 1.0}};
  const VectorChannel path{.joint = 1, .times = {0.0, 0.4, 1.0}, .values = places};
  const Clip clip{.name = "lean", .rotations = {turns}, .translations = {path}};
  const Skeleton skeleton = below_node();
  const Clip here = with_root_motion(skeleton, clip, {.joint = 1}).value(),
             moved = with_root_motion(skeleton, clip, {.joint = 1, .node = 0}).value();
  const ClipMotion was(skeleton, clip), in_place(skeleton, here), is(skeleton, moved);
  const Eigen::Vector3d start = was.world_pose(1, 0.0).translation();
  for (int k = 0; k <= 500; ++k) {
    const double t = k / 500.0;
    const Eigen::Affine3d before = was.world_pose(1, t), now = in_place.world_pose(1, t);
    // The angle between up and an axis of the joint is its leaning.
    for (const int axis : {0, 1, 2}) EXPECT_NEAR(now.linear()(1, axis), before.linear()(1, axis), 2e-4) << t;
    EXPECT_LE((now.translation() - Eigen::Vector3d(start.x(), before.translation().y(), start.z())).norm(), 1e-3) << t;
    EXPECT_LE((is.world_pose(2, t).translation() - was.world_pose(2, t).translation()).norm(), 2e-3) << t;
  }
}

TEST(RootMotion, NamesANodeThatIsNotAbove) {
  const auto moved = with_root_motion(below_armature(), walk_below(), {.joint = 1, .node = 2});
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().message,
            "clip 'walk', joint 'leg': found it not above joint 'hips', wanted one above it, which can carry it");
  EXPECT_EQ(topmost_above(below_armature(), 2), 0u);
  EXPECT_EQ(topmost_above(below_armature(), 0), no_parent);
}

}}  // namespace orispline
