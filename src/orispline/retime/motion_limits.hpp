// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/fields/quantity.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a vector shall not exceed: its length, or each of its three components.
struct Limit {
  std::vector<double> sizes{};  ///< one of the length, or those of x, y, z; in the unit of the library
  Unit stated_in{"", 1.0};      ///< that messages and pages show it in; without a name in the usual one

  Limit() = default;
  Limit(double length) : sizes{length} {}  // NOLINT: a number is a limit of the length
  Limit(const Eigen::Vector3d& components)
      : sizes{components.x(), components.y(), components.z()} {}  // NOLINT: three numbers are one for each axis

  [[nodiscard]] bool is_per_axis() const noexcept { return sizes.size() == 3; }

  [[nodiscard]] friend bool operator==(const Limit&, const Limit&) = default;
};

/// What the body that follows the motion can do, everywhere and always; absent: not limited. Components are along the
/// axes of the body, of positions along those of the world.
struct MotionLimits {
  std::optional<Limit> rate{};                 ///< ω [rad/s]
  std::optional<Limit> acceleration{};         ///< α [rad/s²]
  std::optional<Limit> jerk{};                 ///< dα/dt [rad/s³]
  std::optional<Limit> torque{};               ///< |I α + ω × I ω| [N m]
  std::optional<Eigen::Matrix3d> inertia{};    ///< I [kg m²], body frame; for the torque
  std::optional<Limit> speed{};                ///< of the position [m/s]
  std::optional<Limit> linear_acceleration{};  ///< of the position [m/s²]
};

/// One number of a motion that is limited: a length or a component of a vector.
struct ORISPLINE_EXPORT LimitedQuantity {
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
[[nodiscard]] ORISPLINE_EXPORT std::vector<LimitedQuantity> quantities_of(const MotionLimits& limits);

/// A value for each of the quantities of a motion, in their order.
using QuantitySizes = std::array<double, most_quantities>;

}}  // namespace orispline
