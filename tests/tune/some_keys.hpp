// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::testing_support {

inline Eigen::Quaterniond turned(double x, double y, double z) { return exp<double>(Eigen::Vector3d(x, y, z)); }

inline Keyframes some_keys() {
  KeyframeData data{.times = {0.0, 0.8, 1.5, 2.9, 3.6, 4.0}, .orientations = {turned(0.1, 0.2, -0.3)}};
  for (const auto& step : {turned(0.5, 0.3, 0.1), turned(0.2, -0.6, 0.4), turned(-0.1, 0.7, 0.9),
                           turned(0.6, 0.1, -0.5), turned(0.3, 0.3, 0.2)})
    data.orientations.push_back(data.orientations.back() * step);
  return Keyframes::make(std::move(data)).value();
}

}  // namespace orispline::testing_support
