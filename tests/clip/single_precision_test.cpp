// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include <orispline/clip/single_precision.hpp>

namespace orispline { namespace {

RotationChannel made_at_random(std::size_t keys) {
  std::mt19937 dice(20240607);
  std::normal_distribution<double> normal;
  RotationChannel channel{.interpolation = ChannelInterpolation::cubicspline};
  for (std::size_t i = 0; i < keys; ++i) {
    const auto four = [&] { return Eigen::Quaterniond(normal(dice), normal(dice), normal(dice), normal(dice)); };
    channel.times.push_back(static_cast<double>(i) / 30.0);
    channel.values.push_back(four().normalized());
    channel.in_tangents.push_back(four());
    channel.out_tangents.push_back(four());
  }
  return channel;
}

bool are_floats(const Eigen::Vector4d& numbers) { return numbers.cast<float>().cast<double>() == numbers; }

TEST(SinglePrecision, IsThatOfAReaderAndStaysSo) {
  const RotationChannel before = made_at_random(1000), once = in_single_precision(before),
                        twice = in_single_precision(once);
  EXPECT_EQ(once.times, twice.times);
  int others = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(once.times[i], static_cast<double>(static_cast<float>(before.times[i])));
    EXPECT_TRUE(are_floats(once.in_tangents[i].coeffs()) && are_floats(once.out_tangents[i].coeffs()));
    const Eigen::Quaterniond &value = once.values[i],
                             read(Eigen::Vector4d(value.coeffs().cast<float>().cast<double>()));
    others += read.normalized().coeffs() == value.coeffs() ? 0 : 1;  // than what a file of it gives
    EXPECT_LT((twice.values[i].coeffs() - value.coeffs()).norm(), 1e-7);
    EXPECT_LT((value.coeffs() - before.values[i].coeffs()).norm(), 2e-7);
  }
  EXPECT_LT(others, 5);
}

TEST(SinglePrecision, LeavesAChannelWhoseTimesItCannotTellApart) {
  const VectorChannel channel{.times = {100.0, 100.000001}, .values = {{0.1, 0, 0}, {0, 0.1, 0}}};
  EXPECT_EQ(in_single_precision(channel).times, channel.times);
  EXPECT_EQ(in_single_precision(channel).values, channel.values);
}

TEST(SinglePrecision, LeavesAChannelOfANumberThatIsTooLarge) {
  const VectorChannel sound{.interpolation = ChannelInterpolation::cubicspline,
                            .times = {0.1, 0.2},
                            .values = {{0.1, 0, 0}, {0, 0.1, 0}},
                            .in_tangents = {{0.1, 0, 0}, {0, 0.1, 0}},
                            .out_tangents = {{0.1, 0, 0}, {0, 0.1, 0}}};
  EXPECT_NE(in_single_precision(sound).times, sound.times);
  std::vector<VectorChannel> too_large(4, sound);
  too_large[0].times[1] = 1e39;
  too_large[1].values[0].x() = -1e39;
  too_large[2].in_tangents[1].y() = 1e39;
  too_large[3].out_tangents[0].z() = 1e39;
  for (const VectorChannel& channel : too_large) {
    EXPECT_FALSE(held_in_single_precision(channel));
    EXPECT_EQ(in_single_precision(channel).times, channel.times);
    EXPECT_EQ(in_single_precision(channel).out_tangents, channel.out_tangents);
  }
}

}}  // namespace orispline
