// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/steady_samples.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "smooth/gyro_motion.hpp"

namespace orispline { namespace {

constexpr std::size_t count = 400;

/// Of a turning body, with noise that is large in every third second, and some samples that are off.
GyroRates noisy_rates(std::uint64_t seed) {
  testing_support::Dice dice(seed);
  const gyro_motion::Motion motion(seed);
  GyroRates gyro;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / 16.0, noise = (k / 16) % 3 == 0 ? 1e-1 : 1e-3;
    const double off = k % 7 == 3 ? dice.between(0.0, 2.0) : 0.0;
    gyro.times.push_back(t);
    gyro.rates.emplace_back(motion.rate(t) + noise * normal_vector(dice) + off * dice.vector());
  }
  return gyro;
}

TEST(SteadySamples, AreAllButSingleWildOnes) {
  testing_support::Dice dice(1);
  KeyframeData data;
  const Eigen::Vector3d rate(0.3, -0.2, 0.5), wild(0.4, 0.1, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / 16.0;
    const Eigen::Vector3d noise = 1e-3 * normal_vector(dice);
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(t * rate)) * exp<double>(k % 10 == 5 ? wild : noise));
  }
  const std::vector<std::size_t> steady = steady_samples(Keyframes::make(std::move(data)).value());
  for (std::size_t k = 5; k < count; k += 10) EXPECT_FALSE(std::ranges::binary_search(steady, k)) << k;
  EXPECT_GE(steady.size(), count * 88 / 100);
}

/// What is usual beside a sample is looked for as far before as behind it.
TEST(SteadySamples, AreTheSameWhereTimeRunsBackward) {
  std::size_t left_out = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const GyroRates gyro = noisy_rates(seed);
    GyroRates backward = gyro;
    for (std::size_t k = 0; k < count; ++k) {
      backward.times[k] = -gyro.times[count - 1 - k];
      backward.rates[k] = gyro.rates[count - 1 - k];
    }
    CountedRates steady = steady_rates(gyro);
    left_out += static_cast<std::size_t>(std::ranges::count(steady, false));
    std::reverse(steady.begin(), steady.end());
    EXPECT_EQ(steady_rates(backward), steady) << seed;
  }
  EXPECT_GT(left_out, 0U);
}

}}  // namespace orispline
