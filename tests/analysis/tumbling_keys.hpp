// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/math/so3.hpp>

namespace orispline {

/// Orientations that turn about changing axes by up to 50°, at the given spacings [s].
inline Keyframes tumbling_keys(const std::vector<double>& spacings) {
  KeyframeData data{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (std::size_t i = 0; i < spacings.size(); ++i) {
    const double x = static_cast<double>(i);
    data.times.push_back(data.times.back() + spacings[i]);
    data.orientations.push_back(
        data.orientations.back() *
        exp<double>({0.5 * std::cos(2.1 * x), 0.5 * std::sin(1.3 * x), 0.4 * std::cos(0.7 * x + 1.0)}));
  }
  return Keyframes::make(std::move(data)).value();
}

inline const std::vector<double> uneven_spacings{0.1, 1.0, 0.1, 1.0, 1.0, 0.1, 0.1, 1.0, 0.1};  // ratios of 10

}  // namespace orispline
