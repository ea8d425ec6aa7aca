// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <orispline/clip/clip.hpp>

namespace orispline {

/// A slow swing of a joint with a jitter, one key per second.
inline RotationChannel swinging(std::size_t joint, int keys = 40) {
  RotationChannel channel{.joint = joint};
  for (int i = 0; i < keys; ++i) {
    const double angle = std::sin(0.1 * i) + (i % 2 == 0 ? 0.01 : -0.01);
    channel.times.push_back(i);
    channel.values.emplace_back(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  }
  return channel;
}

}  // namespace orispline
