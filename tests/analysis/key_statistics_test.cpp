// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/key_statistics.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace orispline { namespace {

using std::numbers::pi;

Eigen::Quaterniond about_z(double angle) { return quaternion_wxyz(std::cos(angle / 2), 0.0, 0.0, std::sin(angle / 2)); }

Keyframes keys_about_z(std::vector<double> times, const std::vector<double>& angles) {
  KeyframeData data{.times = std::move(times)};
  for (const double angle : angles) data.orientations.push_back(about_z(angle));
  return Keyframes::make(std::move(data)).value();
}

TEST(Spread, HasTheMiddleOfAnOddNumberOfFigures) {
  const Spread s = spread_of({5.0, 1.0, 4.0});
  EXPECT_EQ(s.smallest, 1.0);
  EXPECT_EQ(s.median, 4.0);
  EXPECT_EQ(s.largest, 5.0);
  EXPECT_EQ(s.largest_at, 0u);
}

TEST(Spread, AveragesTheMiddleTwoOfAnEvenNumber) { EXPECT_EQ(spread_of({8.0, 1.0, 2.0, 4.0}).median, 3.0); }

TEST(Spread, NamesTheFirstOfEqualLargestFigures) { EXPECT_EQ(spread_of({1.0, 7.0, 7.0}).largest_at, 1u); }

TEST(KeyStatistics, MeasuresSpacingAndStepsWithTheirPlaces) {
  const KeyStatistics s = key_statistics(keys_about_z({10.0, 10.5, 13.5, 14.5}, {0.0, 0.1, 0.4, -0.6}));
  EXPECT_EQ(s.span, 4.5);
  EXPECT_EQ(s.spacing->smallest, 0.5);
  EXPECT_EQ(s.spacing->median, 1.0);
  EXPECT_EQ(s.spacing->largest, 3.0);
  EXPECT_EQ(s.spacing->largest_at, 1u);
  EXPECT_NEAR(s.step->median, 0.3, 1e-15);
  EXPECT_NEAR(s.step->largest, 1.0, 1e-15);
  EXPECT_EQ(s.step->largest_at, 2u);
  EXPECT_TRUE(s.near_half_turns.empty());
}

TEST(KeyStatistics, NamesTheStepsThatMayGoEitherWayRound) {
  const double deg = pi / 180.0;
  const auto s = key_statistics(keys_about_z({0, 1, 2, 3}, {0.0, 180.0 * deg, 358.5 * deg, 538.0 * deg}));
  EXPECT_EQ(s.near_half_turns, (std::vector<std::size_t>{0, 2}));  // 180°, 178.5°, 179.5°
}

TEST(KeyStatistics, HasNeitherSpacingNorStepsForOneKey) {
  const KeyStatistics s = key_statistics(keys_about_z({7.0}, {1.0}));
  EXPECT_EQ(s.span, 0.0);
  EXPECT_FALSE(s.spacing);
  EXPECT_FALSE(s.step);
}

}}  // namespace orispline
