// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/reduce/clip_bytes.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <reduce/recorded_walk.hpp>
#include <reduce/reduced_clip.hpp>

namespace orispline { namespace {

using testing_support::degree;
using testing_support::reduced_clip;

constexpr double tolerance = 0.1 * degree;

Skeleton joints(std::size_t count) {
  std::vector<Joint> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i].name = std::string(1, static_cast<char>('a' + i));
  return Skeleton::make(std::move(all)).value();
}

/// 90 frames that turn about the x axis by that angle [rad].
template <class Angle>
RotationChannel turning(std::size_t joint, const Angle& angle) {
  RotationChannel channel{.joint = joint};
  for (int i = 0; i < 90; ++i) {
    channel.times.push_back(i / 30.0);
    channel.values.push_back(exp<double>(Eigen::Vector3d(0.5 * angle(i), 0.0, 0.0)));
  }
  return channel;
}

double ramp(int i) { return 0.02 * (i < 45 ? i : 90 - i); }
double wave(int i) { return std::sin(0.1 * i); }
/// No three frames on a line, or on a cubic.
double shake(int i) { return 0.3 * std::sin(1e3 * i * i); }

TEST(SmallestClip, CountsFloatsAndEqualTimesOnce) {
  RotationChannel turn = turning(0, ramp);
  VectorChannel shift{.joint = 0, .times = turn.times};
  shift.values = std::vector<Eigen::Vector3d>(90, Eigen::Vector3d::Zero());
  EXPECT_EQ(bytes_of_keys(turn), 90u * 20);
  EXPECT_EQ(bytes_of_keys({.rotations = {turn}, .translations = {shift}}), 90u * (16 + 12 + 4));
  shift.times[1] += 1e-3;
  EXPECT_EQ(bytes_of_keys({.rotations = {turn}, .translations = {shift}}), 90u * (16 + 4 + 12 + 4));
  turn.interpolation = ChannelInterpolation::cubicspline;
  turn.in_tangents = turn.out_tangents = turn.values;
  EXPECT_EQ(bytes_of_keys(turn), 90u * 52);
}

TEST(SmallestClip, WritesEachChannelInTheWayThatTakesFewestBytes) {
  const Clip clip{.name = "mixed", .rotations = {turning(0, ramp), turning(1, wave), turning(2, shake)}};
  const ClipReduction smallest = reduced_clip(joints(3), clip, {.tolerance = tolerance, .method = {smallest_method}});
  const ClipReduction cubic = reduced_clip(joints(3), clip, {.tolerance = tolerance});
  const ClipReduction linear = reduced_clip(joints(3), clip, {.tolerance = tolerance, .method = {"slerp"}});
  EXPECT_LE(smallest.angle.largest.value, tolerance);
  const auto& [straight, curved, random] =
      std::tie(smallest.clip.rotations[0], smallest.clip.rotations[1], smallest.clip.rotations[2]);
  EXPECT_EQ(straight.interpolation, ChannelInterpolation::linear);
  EXPECT_EQ(straight.size(), 3u);
  EXPECT_EQ(curved.interpolation, ChannelInterpolation::cubicspline);
  EXPECT_EQ(random.interpolation, ChannelInterpolation::linear);
  EXPECT_LT(bytes_of_keys(smallest.clip), bytes_of_keys(cubic.clip));
  EXPECT_LT(bytes_of_keys(smallest.clip), bytes_of_keys(linear.clip));
  EXPECT_LT(bytes_of_keys(smallest.clip), bytes_of_keys(clip));
  EXPECT_LE(cubic.rotation_keys, smallest.rotation_keys) << "which is what the default is for";
}

TEST(SmallestClip, IsNeverLargerThanTheClipWasWhoseChannelsShareTheirTimes) {
  // Two frames in ten may go: 72 keys with times of their own take as many bytes as 90 values, or more.
  const auto held_at_times = [](int of) {
    return [of](int i) {
      return i % 10 == 3 || i % 10 == 7 ? 0.5 * (shake(of * (i - 1)) + shake(of * (i + 1))) : shake(of * i);
    };
  };
  Clip clip{.name = "shared"};
  for (std::size_t k = 0; k < 8; ++k) clip.rotations.push_back(turning(k, held_at_times(static_cast<int>(k) + 1)));
  const ClipReduction linear = reduced_clip(joints(8), clip, {.tolerance = tolerance, .method = {"slerp"}});
  ASSERT_LT(linear.rotation_keys, 8u * 90) << "the case asks for nothing otherwise";
  for (const double bound : {1e-3 * tolerance, tolerance, 100 * tolerance}) {
    const ClipReduction found = reduced_clip(joints(8), clip, {.tolerance = bound, .method = {smallest_method}});
    EXPECT_LE(bytes_of_keys(found.clip), bytes_of_keys(clip)) << bound;
    EXPECT_LE(found.angle.largest.value, bound);
  }
}

TEST(SmallestClip, MakesLinesOfCubicsWhereTheseTakeFewerBytes) {
  RotationChannel channel = turning(0, ramp);
  channel.interpolation = ChannelInterpolation::cubicspline;
  const Eigen::Quaterniond none(0.0, 0.0, 0.0, 0.0);
  channel.in_tangents = channel.out_tangents = std::vector<Eigen::Quaterniond>(90, none);
  const Clip clip{.name = "eased", .rotations = {channel}};
  const ClipReduction found = reduced_clip(joints(1), clip, {.tolerance = 2 * degree, .method = {smallest_method}});
  EXPECT_EQ(found.clip.rotations[0].interpolation, ChannelInterpolation::linear);
  EXPECT_LE(found.angle.largest.value, 2 * degree);
}

TEST(SmallestClip, CountsBytesWithinALengthInTheWorldToo) {
  const Clip clip{.name = "mixed", .rotations = {turning(0, ramp), turning(1, wave), turning(2, shake)}};
  const ClipReduceOptions cubics{.world_tolerance = 1e-3};
  ClipReduceOptions options = cubics;
  options.method = {smallest_method};
  const ClipReduction found = reduced_clip(joints(3), clip, options);
  EXPECT_LE(found.distance.largest.value, 1e-3);
  EXPECT_LT(bytes_of_keys(found.clip), bytes_of_keys(reduced_clip(joints(3), clip, cubics).clip));
}

TEST(SmallestClip, DoesNotCloseLoops) {
  const auto refused = check({.tolerance = tolerance, .method = {smallest_method}, .closed = true});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().option, "closed");
}

}}  // namespace orispline
