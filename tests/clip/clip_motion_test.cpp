// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <orispline/clip/clip_motion.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using std::numbers::pi;
using testing_support::about_z;

/// An upper arm of length 2 along x, a forearm of length 1 behind it.
Skeleton arm() {
  JointPose elbow, wrist;
  elbow.translation = {2, 0, 0};
  wrist.translation = {1, 0, 0};
  return Skeleton::make({{.name = "shoulder"},
                         {.name = "elbow", .parent = 0, .rest = elbow},
                         {.name = "wrist", .parent = 1, .rest = wrist}})
      .value();
}

Clip wave() {
  return {.name = "wave",
          .rotations = {{.joint = 0, .times = {0.0, 1.0}, .values = {about_z(0), about_z(pi / 2)}},
                        {.joint = 1, .times = {0.0, 1.0}, .values = {about_z(0), about_z(pi / 2)}}}};
}

TEST(ClipMotion, CarriesJointsByTheirParents) {
  const Skeleton skeleton = arm();
  const auto poses = world_poses(skeleton, wave(), std::array{0.0, 0.5, 1.0});
  ASSERT_EQ(poses.size(), 9u);
  EXPECT_LT((poses[2].translation() - Eigen::Vector3d(3, 0, 0)).norm(), 1e-15);
  const double r = std::sqrt(0.5);
  EXPECT_LT((poses[5].translation() - Eigen::Vector3d(2 * r, 2 * r + 1, 0)).norm(), 1e-15);
  EXPECT_LT((poses[8].translation() - Eigen::Vector3d(-1, 2, 0)).norm(), 1e-15);
}

TEST(ClipMotion, HoldsUnevenAndNegativeScales) {
  const Skeleton skeleton = arm();
  Clip clip = wave();
  clip.scales.push_back({.joint = 0, .times = {0.0}, .values = {{-3, 1, 0.5}}});
  const auto poses = world_poses(skeleton, clip, std::array{1.0});
  // The elbow is at (2, 0, 0) of a shoulder whose x axis is thrice as long and points back, and turned to y by 90°.
  EXPECT_LT((poses[1].translation() - Eigen::Vector3d(0, -6, 0)).norm(), 1e-14);
  // The wrist is at (0, 1, 0) behind the elbow, along the shoulder's y, which is not scaled and points to -x.
  EXPECT_LT((poses[2].translation() - Eigen::Vector3d(-1, -6, 0)).norm(), 1e-14);
  EXPECT_NEAR(poses[0].linear().determinant(), -1.5, 1e-14);
}

TEST(ClipMotion, TakesTheRestPoseWhereThereIsNoChannel) {
  const Skeleton skeleton = arm();
  const Clip none;
  const ClipMotion motion(skeleton, none);
  EXPECT_EQ(motion.local_pose(1, 5.0).translation, Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(none.domain().start, 0.0);
  EXPECT_EQ(none.domain().end, 0.0);
}

}}  // namespace orispline
