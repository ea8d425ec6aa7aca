// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/decimation.hpp>

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

namespace orispline { namespace {

using Indices = std::vector<std::size_t>;

TEST(Decimation, KeepsTheLastSampleOnlyWhereItFallsOnTheGrid) {
  EXPECT_EQ(kept_samples({.keep_every = 4}, 9), (Indices{0, 4, 8}));
  EXPECT_EQ(kept_samples({.keep_every = 4}, 10), (Indices{0, 4, 8}));
  EXPECT_EQ(kept_samples({.keep_every = 4}, 1), (Indices{0}));
}

TEST(Decimation, JittersByUpToAThirdOfTheStepAndKeepsTheFirst) {
  const auto kept = kept_samples({.keep_every = 20, .spacing = Spacing::jittered, .seed = 7}, 2000);
  ASSERT_GE(kept.size(), 99u);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto shift = static_cast<double>(kept[i]) - 20.0 * static_cast<double>(i);
    EXPECT_LE(std::abs(shift), 7.0) << i;
    moved += shift != 0.0 ? 1 : 0;
  }
  EXPECT_EQ(kept.front(), 0u);
  EXPECT_GT(moved, 80u);
}

TEST(Decimation, DrawsStepsOfAQuarterToTwiceAtRandom) {
  const auto kept = kept_samples({.keep_every = 8, .spacing = Spacing::random, .seed = 3}, 4000);
  std::array<std::size_t, 17> steps{};
  for (std::size_t i = 1; i < kept.size(); ++i) ++steps.at(kept[i] - kept[i - 1]);
  for (const std::size_t step : {2u, 4u, 8u, 16u}) EXPECT_GT(steps.at(step), 80u) << step;
  EXPECT_EQ(steps[2] + steps[4] + steps[8] + steps[16], kept.size() - 1);
}

TEST(Decimation, DependsOnTheSeedAlone) {
  const Decimation first{.keep_every = 16, .spacing = Spacing::random, .seed = 1};
  Decimation second = first;
  EXPECT_EQ(kept_samples(first, 500), kept_samples(second, 500));
  second.seed = 2;
  EXPECT_NE(kept_samples(first, 500), kept_samples(second, 500));
}

// By std::mt19937_64, whose numbers the standard states: N + 0.35 N (2 d − 1), d being the upper 53 bits as a fraction.
TEST(Decimation, TakesTheVerySamplesThatItsSeedSays) {
  EXPECT_EQ(kept_samples({.keep_every = 10, .spacing = Spacing::jittered, .seed = 7}, 100),
            (Indices{0, 12, 23, 27, 43, 47, 57, 72, 83, 88}));
  EXPECT_EQ(kept_samples({.spacing = Spacing::jittered, .seed = 3}, 100),
            (Indices{0, 8, 14, 25, 31, 40, 47, 57, 64, 73, 78, 86, 97}));
}

TEST(Decimation, NeverStandsStill) {
  for (const Spacing spacing : {Spacing::even, Spacing::jittered, Spacing::random})
    for (std::size_t step = 1; step <= 8; ++step)
      for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        const auto kept = kept_samples({.keep_every = step, .spacing = spacing, .seed = seed}, 100);
        ASSERT_EQ(std::ranges::adjacent_find(kept, std::greater_equal{}), kept.end()) << step << ", seed " << seed;
        ASSERT_LT(kept.back(), 100u);
      }
}

TEST(Decimation, JittersEveryOtherSampleWithoutTakingOneTwice) {
  const auto kept = kept_samples({.keep_every = 2, .spacing = Spacing::jittered, .seed = 47}, 5);
  EXPECT_EQ(kept, (Indices{0, 3, 4}));
  const auto many = kept_samples({.keep_every = 2, .spacing = Spacing::jittered, .seed = 47}, 2000);
  EXPECT_EQ(many.size(), 1000u);
  EXPECT_GT(std::ranges::count_if(many, [](std::size_t index) { return index % 2 != 0; }), 200);  // 286 in the mean
}

TEST(Decimation, KeepsWhatTheKeysCarry) {
  KeyframeData data{.times = {0, 1, 2}, .orientations = std::vector(3, Eigen::Quaterniond::Identity())};
  data.angular_velocities = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  data.inner_leaving = {free_inner(), free_inner(), quaternion_wxyz(0, 1, 0, 0)};
  const Indices kept{0, 2};
  const KeyframeData result = kept_keys(data, kept);
  EXPECT_EQ(result.times, (std::vector<double>{0, 2}));
  EXPECT_EQ(result.angular_velocities[1], Eigen::Vector3d(3, 0, 0));
  EXPECT_EQ(result.inner_leaving[1].x(), 1.0);
  EXPECT_TRUE(result.positions.empty() && result.inner_arriving.empty());
}

TEST(Decimation, HasAName) {
  EXPECT_EQ(name_of({.keep_every = 2}), "every 2nd");
  EXPECT_EQ(name_of({.keep_every = 11}), "every 11th");
  EXPECT_EQ(name_of({.keep_every = 21}), "every 21st");
  EXPECT_EQ(name_of({.keep_every = 8, .spacing = Spacing::jittered, .seed = 5}), "every 8th, jittered (seed 5)");
}

}}  // namespace orispline
