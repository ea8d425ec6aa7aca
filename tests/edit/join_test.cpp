// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/edit/channel_path.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/join.hpp>

#include "edit/moving_clips.hpp"

namespace orispline { namespace {

using namespace testing_support;

/// A take that begins elsewhere and heads elsewhere.
Clip elsewhere() {
  Clip clip = shifted(walk(1.5, 0.1, 0.3), 2.0);
  for (Eigen::Quaterniond& q : clip.rotations[0].values) q = turned(0.0, 2.0, 0.0) * q;
  for (Eigen::Vector3d& v : clip.translations[0].values)
    v = turned(0.0, 2.0, 0.0) * v + Eigen::Vector3d(5.0, 0.0, -7.0);
  return clip;
}

TEST(Blended, HasTheMotionOfTheClipThatGoesOnAtEitherEnd) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const RotationChannel first = random_rotations(seed, ChannelInterpolation::linear, 0.6),
                          second = random_rotations(seed + 100, ChannelInterpolation::cubicspline, 0.6);
    const Domain over{first.times[2] + 0.01, first.times[4] - 0.02};
    const RotationChannel there = part_of(second, over.start - 0.1, over.end + 0.1);
    const AnyCurve a = meant_curve(first).value(), b = meant_curve(there).value();
    const AnyCurve curve = blended(a, b, over);
    for (const auto& [t, side, own] : {std::tuple{over.start, Side::right, a}, std::tuple{over.end, Side::left, b}}) {
      const Motion is = curve.motion(t, side), wanted = own.motion(t, side);
      EXPECT_LE(angular_distance(is.orientation, wanted.orientation), 1e-12);
      EXPECT_LE((is.angular_velocity - wanted.angular_velocity).norm(), 1e-9);
      EXPECT_LE((is.angular_acceleration - wanted.angular_acceleration).norm(), 1e-6);
    }
  }
}

TEST(Joined, GoesOnWithTheSecondClip) {
  const Clip first = walk(1.0, 0.2, 0.0), second = elsewhere();
  const JoinedClip all = joined(two_joints(), first, second, {.blend = 0.2}).value();
  EXPECT_NEAR(all.clip.domain().end, 1.0 + 1.5 - 0.2, 1e-9);
  EXPECT_NEAR(all.blend.start, 0.8, 1e-9);
  EXPECT_TRUE(check_clip(two_joints(), all.clip));
  const Skeleton skeleton = two_joints();
  const ClipMotion is(skeleton, all.clip), was(skeleton, first), will(skeleton, second);
  for (const double t : {0.0, 0.3, 0.7, all.blend.start}) {
    EXPECT_LE(angular_distance(is.local_pose(1, t).rotation, was.local_pose(1, t).rotation), 1e-12);
    EXPECT_LE((is.local_pose(0, t).translation - was.local_pose(0, t).translation).norm(), 1e-12);
  }
  // Behind the blend it is the second clip, turned and moved as a whole.
  const Eigen::Quaterniond turn = turned(0.0, all.turn, 0.0);
  const auto shift_at = [&](double t) {
    return Eigen::Vector3d(is.local_pose(0, t).translation -
                           turn * will.local_pose(0, t - all.blend.start + 2.0).translation);
  };
  for (const double t : {all.blend.end, 1.4, 2.3}) {
    const double own = t - all.blend.start + 2.0;
    EXPECT_LE(angular_distance(is.local_pose(1, t).rotation, will.local_pose(1, own).rotation), 1e-9);
    EXPECT_LE(angular_distance(is.local_pose(0, t).rotation, turn * will.local_pose(0, own).rotation), 1e-9);
    EXPECT_LE((shift_at(t) - shift_at(2.0)).norm(), 1e-9);
    EXPECT_NEAR(shift_at(t).y(), 0.0, 1e-9);
  }
}

TEST(Joined, LetsTheRootGoOn) {
  const Clip first = walk(1.0, 0.0, 0.0);
  const JoinedClip all = joined(two_joints(), first, elsewhere(), {.blend = 0.2}).value();
  const std::vector<double> times = all.clip.translations[0].times;
  const SharedList<Eigen::Vector3d>& path = all.clip.translations[0].values;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double speed = (path[i + 1] - path[i]).norm() / (times[i + 1] - times[i]);
    EXPECT_GT(speed, 0.8) << times[i];
    EXPECT_LT(speed, 1.7) << times[i];
  }
}

TEST(Joined, LetsANodeAboveTheRootGoOn) {
  const Skeleton skeleton = below_node({.translation = {0.5, 0.0, 0.0}, .rotation = turned(0.0, 0.7, 0.0)});
  const Clip clip = walk_of_node(0.6);
  for (const std::size_t root : {std::size_t{0}, std::size_t{1}, no_parent}) {
    const JoinedClip all = joined(skeleton, clip, clip, {.blend = 0.2, .root = root}).value();
    const ClipMotion is(skeleton, all.clip);
    Eigen::Vector3d last = is.world_pose(1, 0.0).translation();
    for (int k = 1; k <= 180; ++k) {
      const Eigen::Vector3d next = is.world_pose(1, k / 100.0).translation();
      EXPECT_GT((next - last).norm(), 0.004) << k;
      EXPECT_LT((next - last).norm(), 0.025) << k;
      last = next;
    }
  }
}

TEST(Joined, MovesTheSecondClipAsAWhole) {
  const Skeleton skeleton =
      Skeleton::make({{.name = "a"}, {.name = "b"}, {.name = "door", .rest = {.translation = {3.0, 0.0, 0.0}}}})
          .value();
  Clip clip = walk(1.0, 0.0, 0.0);
  clip.rotations[1].joint = 2;
  VectorChannel beside = clip.translations[0];
  beside.joint = 1;
  for (Eigen::Vector3d& v : beside.values) v += Eigen::Vector3d(0.0, 0.0, 2.0);
  clip.translations.push_back(beside);
  const JoinedClip all = joined(skeleton, clip, clip, {.blend = 0.2, .root = 0}).value();
  const ClipMotion is(skeleton, all.clip);
  EXPECT_LE(std::abs(all.turn), 0.01);
  for (int k = 0; k <= 18; ++k) {
    const Eigen::Vector3d apart = is.world_pose(1, k / 10.0).translation() - is.world_pose(0, k / 10.0).translation();
    EXPECT_LE((apart - Eigen::Vector3d(0.0, 0.0, 2.0)).norm(), 2.1 * std::abs(all.turn) + 1e-9) << k;
    EXPECT_LE((is.world_pose(2, k / 10.0).translation() - Eigen::Vector3d(3.0, 0.0, 0.0)).norm(), 1e-12) << k;
  }
}

TEST(Joined, HasOneKeyWhereFramesOfBothAreAtOneTime) {
  const JoinedClip all = joined(two_joints(), walk(1.0, 0.2, 0.0), elsewhere(), {.blend = 0.2}).value();
  EXPECT_EQ(all.clip.rotations[1].size(), 31u + 46u - 7u);
}

TEST(Joined, KeepsCubicsAndJoinsThemWithLinearOnes) {
  const Clip cubic{.name = "cubic", .rotations = {random_rotations(2, ChannelInterpolation::cubicspline, 0.3)}};
  for (const ChannelInterpolation interpolation : {ChannelInterpolation::cubicspline, ChannelInterpolation::linear}) {
    const Clip other{.name = "other", .rotations = {random_rotations(3, interpolation, 0.3)}};
    for (const auto& [first, second] : {std::pair{cubic, other}, std::pair{other, cubic}}) {
      const JoinedClip all = joined(two_joints(), first, second, {.blend = 0.25}).value();
      EXPECT_TRUE(check_clip(two_joints(), all.clip));
      const Skeleton skeleton = two_joints();
      const ClipMotion is(skeleton, all.clip), was(skeleton, first), will(skeleton, second);
      const double start = first.domain().start, end = all.clip.domain().end;
      for (int k = 0; k < 50; ++k) {
        const double t = start + (all.blend.start - start) * k / 50.0,
                     late = all.blend.end + (end - all.blend.end) * k / 50.0;
        EXPECT_LE(angular_distance(is.local_pose(1, t).rotation, was.local_pose(1, t).rotation), 1.1e-5);
        EXPECT_LE(angular_distance(is.local_pose(1, late).rotation,
                                   will.local_pose(1, late - all.blend.start + second.domain().start).rotation),
                  1.1e-5);
      }
    }
  }
}

TEST(Joined, ChangesStepsInTheMiddle) {
  RotationChannel steps{.joint = 1, .interpolation = ChannelInterpolation::step, .times = {0.0, 0.5, 1.0}};
  steps.values = {turned(0.1, 0.0, 0.0), turned(0.2, 0.0, 0.0), turned(0.3, 0.0, 0.0)};
  const JoinedClip all = joined(two_joints(), {.rotations = {steps}}, {.rotations = {steps}}, {.blend = 0.2}).value();
  const ChannelCurve<Eigen::Quaterniond> curve(all.clip.rotations[0]);
  EXPECT_LE(angular_distance(curve.at(0.85), turned(0.2, 0.0, 0.0)), 1e-12);
  EXPECT_LE(angular_distance(curve.at(0.95), turned(0.1, 0.0, 0.0)), 1e-12);
}

TEST(Joined, LetsAJointRestThatOneClipDoesNotMove) {
  Clip still = walk(1.0, 0.0, 0.0);
  still.rotations.pop_back();
  const JoinedClip all = joined(two_joints(), walk(1.0, 0.0, 0.0), still, {.blend = 0.2}).value();
  ASSERT_EQ(all.clip.rotations.size(), 2u);
  EXPECT_LE(angular_distance(all.clip.rotations[1].values.back(), turned(0.0, 0.0, 0.0)), 1e-12);
}

TEST(Joined, RefusesABlendThatIsLongerThanAClip) {
  const auto all = joined(two_joints(), walk(1.0, 0.0, 0.0), walk(0.5, 0.0, 0.0), {.blend = 0.5});
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().option, "blend");
}

TEST(WithJointsOf, FindsTheJointsAndNamesThoseThatDiffer) {
  const Skeleton other =
      Skeleton::make(
          {{.name = "prop"}, {.name = "hips"}, {.name = "leg", .parent = 1, .rest = {.translation = {0.0, -0.5, 0.0}}}})
          .value();
  Clip clip = walk(1.0, 0.0, 0.0);
  for (RotationChannel& channel : clip.rotations) channel.joint += 1;
  for (VectorChannel& channel : clip.translations) channel.joint += 1;
  const Clip found = with_joints_of(two_joints(), walk(1.0, 0.0, 0.0), other, clip).value();
  EXPECT_EQ(found.rotations[1].joint, 1u);
  const auto refused = [&](std::vector<Joint> joints) {
    return with_joints_of(two_joints(), walk(1.0, 0.0, 0.0), Skeleton::make(std::move(joints)).value(),
                          walk(1.0, 0.0, 0.0))
        .error()
        .message;
  };
  EXPECT_EQ(refused({{.name = "hips"}, {.name = "foot", .parent = 0}}),
            "joint 'leg': found no such joint in the second file, wanted the same skeleton in both files");
  EXPECT_EQ(
      refused({{.name = "hips"}, {.name = "leg", .parent = 0, .rest = {.translation = {0.0, -0.6, 0.0}}}}),
      "joint 'leg': found rest poses that differ by 0° and 0.1 of length, wanted the same skeleton in both files");
}

}}  // namespace orispline
