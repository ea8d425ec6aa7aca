// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/math/eigen.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One number of a motion that is limited: a length or a component of a vector.
struct LimitedQuantity {
  enum class Vector { rate, acceleration, jerk, torque, speed, linear_acceleration };

  Vector vector;
  std::optional<std::size_t> axis;  ///< absent: the length
  double limit;                     ///< in the unit of the library
  Unit stated_in;

  /// The length of a vector, or the size of the component.
  [[nodiscard]] double size_of(const Eigen::Vector3d& v) const noexcept {
    return axis ? std::abs(v[static_cast<Eigen::Index>(*axis)]) : v.norm();
  }
  /// Slowed by s the number is so often divided by s.
  [[nodiscard]] int order() const noexcept;
  [[nodiscard]] bool is_of_position() const noexcept {
    return vector == Vector::speed || vector == Vector::linear_acceleration;
  }
};

inline constexpr std::size_t most_quantities = 16;

/// Those that the limits name, at most `most_quantities`.
[[nodiscard]] std::vector<LimitedQuantity> quantities_of(const MotionLimits& limits);

/// A value for each of the quantities of a motion, in their order.
using QuantitySizes = std::array<double, most_quantities>;

/// By which factor a segment must be slowed at least, below 1 where it could be faster: each quantity goes with 1/s to
/// the power of its order.
[[nodiscard]] double needed_factor(const QuantitySizes& peaks, std::span<const LimitedQuantity> quantities);

}}  // namespace orispline
