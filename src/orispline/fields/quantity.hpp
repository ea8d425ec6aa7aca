// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <orispline/base/abi.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A unit as people type it, and how many of the unit of the library it is.
struct Unit {
  std::string_view name;
  double size;

  [[nodiscard]] friend bool operator==(const Unit&, const Unit&) = default;
};

/// What a number measures.
struct Quantity {
  std::string_view name;                ///< `rate`
  std::string_view unit;                ///< of the number: `rad/s`
  std::string_view suffix;              ///< that unit in names: `noise_rad_s`
  std::span<const Unit> typed_units{};  ///< those that people type behind a number; none: they type the number alone
  std::string_view example{};           ///< typed
  double shown = 1.0;                   ///< times the number of the library, where `unit` is another than its own
};

/// Units of what may be stated in several.
namespace units {
inline constexpr double radians_per_arcsecond = radians_per_degree / 3600.0;
inline constexpr std::array angle{Unit{"deg", radians_per_degree}, Unit{"°", radians_per_degree}, Unit{"rad", 1.0},
                                  Unit{"mrad", 1e-3}, Unit{"arcsec", radians_per_arcsecond}};
inline constexpr std::array length{Unit{"mm", 1e-3}, Unit{"cm", 1e-2}, Unit{"m", 1.0}};
// Other ways of writing a unit come after it.
inline constexpr std::array rate{Unit{"deg/s", radians_per_degree}, Unit{"°/s", radians_per_degree}, Unit{"rad/s", 1.0},
                                 Unit{"mrad/s", 1e-3}, Unit{"arcsec/s", radians_per_arcsecond}};
inline constexpr std::array acceleration{Unit{"deg/s2", radians_per_degree},
                                         Unit{"deg/s^2", radians_per_degree},
                                         Unit{"deg/s²", radians_per_degree},
                                         Unit{"°/s2", radians_per_degree},
                                         Unit{"°/s^2", radians_per_degree},
                                         Unit{"°/s²", radians_per_degree},
                                         Unit{"rad/s2", 1.0},
                                         Unit{"rad/s^2", 1.0},
                                         Unit{"rad/s²", 1.0}};
inline constexpr std::array jerk{Unit{"deg/s3", radians_per_degree},
                                 Unit{"deg/s^3", radians_per_degree},
                                 Unit{"deg/s³", radians_per_degree},
                                 Unit{"°/s3", radians_per_degree},
                                 Unit{"°/s^3", radians_per_degree},
                                 Unit{"°/s³", radians_per_degree},
                                 Unit{"rad/s3", 1.0},
                                 Unit{"rad/s^3", 1.0},
                                 Unit{"rad/s³", 1.0}};
inline constexpr std::array torque{Unit{"Nm", 1.0}, Unit{"N m", 1.0}, Unit{"N·m", 1.0}};
inline constexpr std::array speed{Unit{"mm/s", 1e-3}, Unit{"cm/s", 1e-2}, Unit{"m/s", 1.0}};
inline constexpr std::array linear_acceleration{Unit{"mm/s2", 1e-3}, Unit{"mm/s^2", 1e-3}, Unit{"mm/s²", 1e-3},
                                                Unit{"m/s2", 1.0},   Unit{"m/s^2", 1.0},   Unit{"m/s²", 1.0}};
/// A number alone is seconds.
inline constexpr std::array time{Unit{"ms", 1e-3}, Unit{"s", 1.0}, Unit{"min", 60.0}, Unit{"", 1.0}};
}  // namespace units

namespace quantities {
inline constexpr Quantity angle{"angle", "rad", "rad", units::angle, "1deg or 0.02rad"};
inline constexpr Quantity angle_in_degrees{"angle", "°", "deg", {}, {}, degrees};
inline constexpr Quantity length{"length", "m", "m", units::length, "1mm or 0.5m"};
inline constexpr Quantity rate{"rate", "rad/s", "rad_s", units::rate, "90deg/s"};
inline constexpr Quantity acceleration{"acceleration", "rad/s²", "rad_s2", units::acceleration, "200deg/s2"};
inline constexpr Quantity jerk{"jerk", "rad/s³", "rad_s3", units::jerk, "2000deg/s3"};
inline constexpr Quantity torque{"torque", "N m", "nm", units::torque, "0.5Nm"};
inline constexpr Quantity speed{"speed", "m/s", "m_s", units::speed, "0.5m/s"};
inline constexpr Quantity linear_acceleration{"acceleration", "m/s²", "m_s2", units::linear_acceleration, "2m/s2"};
inline constexpr Quantity inertia{"inertia", "kg m²", "kg_m2"};
inline constexpr Quantity time{"time", "s", "s"};
inline constexpr Quantity duration{"time", "s", "s", units::time, "20s"};
inline constexpr Quantity frequency{"frequency", "Hz", "hz"};
}  // namespace quantities

/// Which of two values of a measure is the better one.
enum class Better { less, more, neither };

}}  // namespace orispline
