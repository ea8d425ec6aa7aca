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

TEST(KeyTimes, AreThoseOfAllChannelsEachOnce) {
  const Clip clip{.name = "c",
                  .rotations = {{.joint = 0, .times = {0.0, 2.0}, .values = {about_z(0), about_z(1)}}},
                  .translations = {{.joint = 0, .times = {0.0, 1.0}, .values = {{0, 0, 0}, {1, 0, 0}}}}};
  EXPECT_EQ(key_times(clip), (std::vector<double>{0.0, 1.0, 2.0}));
}

}}  // namespace orispline
