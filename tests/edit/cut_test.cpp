// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/edit/cut.hpp>

#include "edit/moving_clips.hpp"

namespace orispline { namespace {

using namespace testing_support;

constexpr std::array all_interpolations{ChannelInterpolation::step, ChannelInterpolation::linear,
                                        ChannelInterpolation::cubicspline};

double apart(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return angular_distance(a, b); }
double apart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); }

/// The largest distance of two curves over a part, of which the second one is on a clock of its own.
template <CurvePoint P, class Clock>
double farthest(const Channel<P>& before, const Channel<P>& after, Domain part, const Clock& clock) {
  const ChannelCurve<P> first(before), second(after);
  double largest = 0.0;
  for (int k = 0; k < 997; ++k) {  // between the keys: a step may be seen from either side there
    const double t = part.start + (part.end - part.start) * (k + 0.437) / 997.0;
    largest = std::max(largest, apart(first.at(t), second.at(clock(t))));
  }
  return largest;
}

const auto same_clock = [](double t) { return t; };

TEST(Cut, LeavesTheCurveAsItWas) {
  for (const ChannelInterpolation interpolation : all_interpolations)
    for (unsigned seed = 0; seed < 20; ++seed) {
      const RotationChannel rotation = random_rotations(seed, interpolation, 0.7);
      const VectorChannel vector = random_vectors(seed, interpolation);
      const Domain part{rotation.times[1] + 0.07, rotation.times[5] - 0.011};
      const RotationChannel cut = part_of(rotation, part.start, part.end);
      const double limit = interpolation == ChannelInterpolation::cubicspline ? 1e-7 : 1e-13;
      EXPECT_LE(farthest(rotation, cut, part, same_clock), limit) << seed;
      EXPECT_LE(farthest(vector, part_of(vector, part.start, part.end), part, same_clock), 1e-14) << seed;
      EXPECT_EQ(cut.times.front(), part.start);
      EXPECT_EQ(cut.times.back(), part.end);
      EXPECT_TRUE(check_clip(two_joints(), {.rotations = {cut}}));
    }
}

TEST(Cut, NeedsFewMoreKeysOfCubicsAsExportersWriteThem) {
  // A swing of 60° to either side with a key every 0.1 s, 20° apart at most, whose tangents are those of the curve.
  RotationChannel swing{.joint = 1, .interpolation = ChannelInterpolation::cubicspline};
  for (int i = 0; i <= 10; ++i) {
    const double half = 0.5 * 1.047 * std::sin(3.0 * 0.1 * i), rate = 0.5 * 1.047 * 3.0 * std::cos(3.0 * 0.1 * i);
    swing.times.push_back(0.1 * i);
    swing.values.emplace_back(std::cos(half), std::sin(half), 0.0, 0.0);
    swing.out_tangents.emplace_back(-rate * std::sin(half), rate * std::cos(half), 0.0, 0.0);
  }
  swing.in_tangents = swing.out_tangents;
  EXPECT_EQ(part_of(swing, 0.23, 0.87).size(), 8u);
}

TEST(Cut, NeedsFewMoreKeysOfCubicsThatTurnFar) {
  // From key to key a half turn, eased in and out.
  for (const double bend : {0.0, 0.4}) {
    RotationChannel turn{.joint = 1, .interpolation = ChannelInterpolation::cubicspline, .times = {0.0, 1.0, 2.0}};
    turn.values = {turned(0.0, 0.0, 0.0), turned(bend, 0.0, 3.0), turned(0.0, bend, 3.0) * turned(0.0, 0.0, 3.0)};
    turn.in_tangents = turn.out_tangents = std::vector(3, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0));
    const RotationChannel cut = part_of(turn, 0.3, 1.8);
    EXPECT_LE(farthest(turn, cut, {0.3, 1.8}, same_clock), 1e-7) << bend;
    EXPECT_LE(cut.size(), 24u) << bend;
  }
}

TEST(Cut, KeepsThatAChannelStandsStillBeyondItsKeys) {
  for (const ChannelInterpolation interpolation : all_interpolations) {
    const RotationChannel channel = random_rotations(5, interpolation);
    const Domain part{channel.times.front() - 1.0, channel.times.back() + 1.0};
    const RotationChannel cut = part_of(channel, part.start, part.end);
    EXPECT_LE(farthest(channel, cut, part, same_clock), 1e-13);
    EXPECT_EQ(cut.times.front(), part.start);
    EXPECT_EQ(cut.times.back(), part.end);
    const RotationChannel behind = part_of(channel, channel.times.back() + 1.0, channel.times.back() + 2.0);
    EXPECT_EQ(behind.values.front().coeffs(), channel.values.back().coeffs());
    EXPECT_EQ(behind.size(), 2u);
  }
}

TEST(Cut, KeepsTheOneKeyOfAChannel) {
  const RotationChannel one{.joint = 1, .times = {0.3}, .values = {turned(0.1, 0.2, 0.3)}};
  const RotationChannel cut = part_of(one, 0.5, 0.7);
  EXPECT_EQ(cut.times, SharedList<double>({0.5}));
  EXPECT_EQ(cut.values.front().coeffs(), one.values.front().coeffs());
}

TEST(Cut, TakesATimeForThatOfAKeyWithinTheRoundingOfFloats) {
  const Clip clip{
      .rotations = {{.joint = 1, .times = {0.0, double{0.4F}, 1.0}, .values = std::vector(3, turned(0.0, 0.0, 0.0))}}};
  EXPECT_EQ(key_time_near(clip, 0.4), double{0.4F});
  EXPECT_EQ(key_time_near(clip, 0.41), 0.41);
  EXPECT_EQ(key_time_near(clip, -1.0), -1.0);
  EXPECT_EQ(key_time_near(clip, 2.0), 2.0);
}

TEST(Reversed, GoesBackwards) {
  for (const ChannelInterpolation interpolation : all_interpolations)
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Clip clip{.rotations = {random_rotations(seed, interpolation)},
                      .translations = {random_vectors(seed + 1, interpolation)}};
      const Clip back = reversed(clip);
      const Domain whole = clip.domain();
      EXPECT_EQ(back.domain().start, whole.start);
      EXPECT_NEAR(back.domain().end, whole.end, 1e-15);
      const auto clock = [&](double t) { return whole.start + whole.end - t; };
      EXPECT_LE(farthest(clip.rotations[0], back.rotations[0], whole, clock), 1e-13);
      EXPECT_LE(farthest(clip.translations[0], back.translations[0], whole, clock), 1e-13);
      EXPECT_TRUE(check_clip(two_joints(), back));
    }
}

TEST(WithSpeed, KeepsTheCurveOnAnotherClock) {
  for (const ChannelInterpolation interpolation : all_interpolations) {
    const Clip clip{.rotations = {random_rotations(8, interpolation)},
                    .translations = {random_vectors(9, interpolation)}};
    const Clip fast = with_speed(clip, 2.5);
    const Domain whole = clip.domain();
    const auto clock = [&](double t) { return whole.start + (t - whole.start) / 2.5; };
    EXPECT_LE(farthest(clip.rotations[0], fast.rotations[0], whole, clock), 1e-13);
    EXPECT_LE(farthest(clip.translations[0], fast.translations[0], whole, clock), 1e-13);
    EXPECT_NEAR(fast.domain().end - fast.domain().start, (whole.end - whole.start) / 2.5, 1e-15);
  }
}

TEST(Resampled, HasEvenKeysAndOneAtTheEnd) {
  for (const ChannelInterpolation interpolation : all_interpolations) {
    const Clip clip{.rotations = {random_rotations(8, interpolation)},
                    .translations = {random_vectors(9, interpolation)}};
    const Clip even = resampled(clip, 7.0);
    const Domain whole = clip.domain();
    EXPECT_EQ(even.domain().start, whole.start);
    EXPECT_EQ(even.domain().end, whole.end);
    EXPECT_TRUE(check_clip(two_joints(), even));
    const RotationChannel& channel = even.rotations[0];
    const ChannelCurve<Eigen::Quaterniond> curve(clip.rotations[0]);
    for (std::size_t i = 0; i < channel.size(); ++i)
      EXPECT_LE(angular_distance(channel.values[i], curve.at(channel.times[i])), 1e-12);
    if (interpolation == ChannelInterpolation::step) continue;
    for (std::size_t i = 0; i + 2 < channel.size(); ++i)
      EXPECT_NEAR(channel.times[i + 1] - channel.times[i], 1.0 / 7.0, 1e-12);
    EXPECT_EQ(channel.interpolation, ChannelInterpolation::linear);
  }
}

TEST(Shifted, MovesAllTimesAlone) {
  const Clip clip{.rotations = {random_rotations(8, ChannelInterpolation::cubicspline)}};
  const Clip late = shifted(clip, 0.5);
  EXPECT_EQ(late.rotations[0].times[2], clip.rotations[0].times[2] + 0.5);
  EXPECT_EQ(late.rotations[0].out_tangents[2].coeffs(), clip.rotations[0].out_tangents[2].coeffs());
}

}}  // namespace orispline
