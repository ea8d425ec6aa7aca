// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include <orispline/curve/keyframe.hpp>

namespace orispline {

/// How keys are drawn.
struct KeyDrawing {
  std::size_t count;
  double largest_step;      ///< [rad]
  double time_ratio = 1.0;  ///< of the longest to the shortest interval; 1: all are 1 s
};

/// Keys about axes of any direction, the same for the same seed.
inline Keyframes random_keys(unsigned seed, const KeyDrawing& how) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> symmetric(-1.0, 1.0);
  KeyframeData data{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  while (data.times.size() < how.count) {
    const Eigen::Vector3d axis(symmetric(generator), symmetric(generator), symmetric(generator));
    const double angle = how.largest_step * (0.55 + 0.45 * symmetric(generator));
    data.orientations.push_back(data.orientations.back() * exp<double>(angle * axis.normalized()));
    data.times.push_back(data.times.back() + std::pow(how.time_ratio, 0.5 * symmetric(generator)));
  }
  return Keyframes::make(std::move(data)).value();
}

}  // namespace orispline
