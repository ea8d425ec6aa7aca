// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <orispline/math/degrees.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

/// A unit as it is typed, and how many of the unit that the library takes it is.
struct Unit {
  std::string_view name;
  double size;
};

inline constexpr double radians_per_degree = 0.017453292519943295;
inline constexpr std::array angle_units{Unit{"deg", radians_per_degree}, Unit{"rad", 1.0}};               ///< [rad]
inline constexpr std::array length_units{Unit{"mm", 1e-3}, Unit{"cm", 1e-2}, Unit{"m", 1.0}};             ///< [m]
inline constexpr std::array rate_units{Unit{"deg/s", radians_per_degree}, Unit{"rad/s", 1.0}};            ///< [rad/s]
inline constexpr std::array acceleration_units{Unit{"deg/s2", radians_per_degree}, Unit{"rad/s2", 1.0}};  ///< [rad/s²]
inline constexpr std::array torque_units{Unit{"Nm", 1.0}};                                                ///< [N m]

/// A finite number above 0 with one of the units behind it, as in `0.1deg`, in the unit that the library takes.
[[nodiscard]] Expected<double> quantity_in(OptionText option, std::span<const Unit> units);

/// The same for a fixed list of units, for `if_given`.
template <std::size_t N>
[[nodiscard]] auto quantity_of(const std::array<Unit, N>& units) {
  return [&units](OptionText option) { return quantity_in(option, units); };
}

}  // namespace orispline::cli
