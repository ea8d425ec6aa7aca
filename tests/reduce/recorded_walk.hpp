// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline::testing_support {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Degrees of freedom of a random recording.
struct Walk {
  std::size_t samples;
  double step;         ///< largest component of the turn from sample to sample [rad]
  double noise;        ///< the same of every sample by itself [rad]
  double shift;        ///< the same of positions [m]; 0: there are none
  double start = 0.0;  ///< time [s]
};

[[nodiscard]] inline Keyframes recorded(const Walk& walk, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0), interval(0.25, 1.75);
  const auto vector = [&] { return Eigen::Vector3d(any(random), any(random), any(random)); };
  KeyframeData data;
  Eigen::Quaterniond at = exp<double>(vector());
  Eigen::Vector3d rate = walk.step * vector(), position = vector();
  double t = walk.start;
  for (std::size_t i = 0; i < walk.samples; ++i) {
    data.times.push_back(t += interval(random));
    if (i % 5 == 4) rate = walk.step * vector();
    at = (at * exp<double>(rate)).normalized();
    data.orientations.push_back(at * exp<double>(Eigen::Vector3d(walk.noise * vector())));
    if (walk.shift > 0.0) data.positions.push_back(position += walk.shift * vector());
  }
  return Keyframes::make(std::move(data)).value();
}

[[nodiscard]] inline Reduction reduced(std::string_view method, const Keyframes& recording,
                                       const ReduceOptions& options) {
  auto reduction = reduce(recording, method, options);
  EXPECT_TRUE(reduction) << method << ": " << (reduction ? "" : describe(reduction.error()));
  return reduction ? std::move(*reduction) : Reduction{.track = recording};
}

}  // namespace orispline::testing_support
