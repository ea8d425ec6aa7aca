// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include <orispline/clip/clip_difference.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::about_z;

Skeleton bone(double length) {
  JointPose tip;
  tip.translation = {length, 0, 0};
  return Skeleton::make({{.name = "root"}, {.name = "tip", .parent = 0, .rest = tip}}).value();
}

Clip turned(double angle) {
  return {.name = "c", .rotations = {{.joint = 0, .times = {0.0}, .values = {about_z(angle)}}}};
}

TEST(Differences, AreAnglesInTheParentAndChordsInTheWorld) {
  const Skeleton skeleton = bone(2.0);
  const double angle = 0.1, shell = 0.03;
  const auto found = differences(ClipMotion(skeleton, turned(0.0)), ClipMotion(skeleton, turned(angle)),
                                 std::array<std::size_t, 2>{0, 1}, std::array{0.0, 1.0}, shell);
  EXPECT_NEAR(found[0].angle.value, angle, 1e-15);
  EXPECT_NEAR(found[0].distance.value, 2 * shell * std::sin(angle / 2), 1e-15);
  EXPECT_EQ(found[1].angle.value, 0.0);
  // The farthest of the shell's points is the one ahead of the tip.
  EXPECT_NEAR(found[1].distance.value, 2 * (2.0 + shell) * std::sin(angle / 2), 1e-15);
}

TEST(Differences, SayWhenTheyAreLargest) {
  const Skeleton skeleton = bone(1.0);
  const Clip moving{
      .name = "c",
      .rotations = {{.joint = 0, .times = {0.0, 1.0, 2.0}, .values = {about_z(0), about_z(0.3), about_z(0)}}}};
  const auto found = differences(ClipMotion(skeleton, turned(0.0)), ClipMotion(skeleton, moving),
                                 std::array<std::size_t, 2>{0, 1}, std::array{0.0, 0.5, 1.0, 1.75, 2.0});
  EXPECT_EQ(found[0].angle.time, 1.0);
  EXPECT_EQ(found[1].distance.time, 1.0);
}

/// Both ends alike, with tangents that swing the root's z and its place by m (u − u²) between.
Clip swinging(double m) {
  const Eigen::Quaterniond still = about_z(0), forth(0, 0, 0, m), back(0, 0, 0, -m);
  const Eigen::Vector3d shift(0, m, 0);
  return {.name = "c",
          .rotations = {{.joint = 0,
                         .interpolation = ChannelInterpolation::cubicspline,
                         .times = {0.0, 1.0},
                         .values = {still, still},
                         .in_tangents = {forth, back},
                         .out_tangents = {forth, back}}},
          .translations = {{.joint = 0,
                            .interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.0, 1.0},
                            .values = {{0, 0, 0}, {0, 0, 0}},
                            .in_tangents = {shift, -shift},
                            .out_tangents = {shift, -shift}}}};
}

TEST(Differences, AreLookedForBetweenTheTimesWhereAskedFor) {
  const Skeleton skeleton = bone(2.0);
  const double m = 0.8, shell = 0.03;
  const ClipMotion still(skeleton, turned(0.0)), moving(skeleton, swinging(m));
  const std::array<std::size_t, 2> same{0, 1};
  const std::array times{0.0, 0.2, 0.4, 0.65, 1.0};
  const auto at_times = differences(still, moving, same, times, shell),
             found = differences(still, moving, same, times, shell, Between::looked_at);
  EXPECT_EQ(at_times[0].angle.time, 0.4);
  // z / w is largest in the middle, m / 4.
  const double angle = 2.0 * std::atan(m / 4.0);
  EXPECT_NEAR(found[0].angle.value, angle, 1e-12);
  EXPECT_NEAR(found[0].angle.time, 0.5, 1e-6);
  EXPECT_NEAR(found[0].translation.value, m / 4.0, 1e-12);
  // The tip, with the shell's point ahead of it: how far it turns and is carried.
  const double reach = 2.0 + shell;
  EXPECT_NEAR(found[1].distance.value, std::hypot(reach * (1.0 - std::cos(angle)), reach * std::sin(angle) + m / 4.0),
              1e-12);
  EXPECT_NEAR(found[1].distance.time, 0.5, 1e-6);
  EXPECT_EQ(found[1].angle.value, 0.0);
  EXPECT_LT(at_times[1].distance.value, found[1].distance.value - 1e-3);
}

TEST(KeyTimes, AreThoseOfAllChannelsEachOnce) {
  const Clip clip{.name = "c",
                  .rotations = {{.joint = 0, .times = {0.0, 2.0}, .values = {about_z(0), about_z(1)}}},
                  .translations = {{.joint = 0, .times = {0.0, 1.0}, .values = {{0, 0, 0}, {1, 0, 0}}}}};
  EXPECT_EQ(key_times(clip), (std::vector<double>{0.0, 1.0, 2.0}));
}

}}  // namespace orispline
