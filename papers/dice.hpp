// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include <orispline/math/so3.hpp>

namespace orispline::cli {

/// Random quantities that are the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(bits_() >> 11U);
  }
  /// Every component in [-1, 1].
  [[nodiscard]] Eigen::Vector3d vector() {
    const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
    return {x, y, z};
  }
  [[nodiscard]] Eigen::Vector3d unit_vector() {
    for (;;)
      if (const Eigen::Vector3d v = vector(); v.norm() > 0.1) return v.normalized();
  }
  /// Of any orientation, angle of half the rotation in [0, π].
  [[nodiscard]] Eigen::Quaterniond unit_quaternion() {
    const Eigen::Vector3d axis = unit_vector();
    return exp<double>(Eigen::Vector3d(2.0 * between(0, 3.1) * axis));
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace orispline::cli
