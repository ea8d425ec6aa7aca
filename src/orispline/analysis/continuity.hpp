// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far one rate of a curve jumps where its segments meet.
struct RateJump {
  double largest = 0.0;    ///< largest ‖right - left‖ at an interior key, in the unit of the rate
  std::size_t key = 0;     ///< where
  double magnitude = 0.0;  ///< largest ‖rate‖ on the curve, found at the keys and at three points of each segment
  double relative = 0.0;   ///< largest / magnitude; 0 where every jump is within the rounding of the rate itself
};

/// The continuity in time that a curve really has on its keys.
struct ORISPLINE_EXPORT Continuity {
  RateJump angular_velocity{};      ///< [rad/s]
  RateJump angular_acceleration{};  ///< [rad/s²]
  RateJump angular_jerk{};          ///< [rad/s³]

  /// The largest k up to 3 for which no rate of order k or lower jumps by more than `continuity_tolerance`.
  [[nodiscard]] int order() const noexcept;
};

/// Relative jumps up to this one pass as continuous.
inline constexpr double continuity_tolerance = 1e-9;

/// Whether the end of a curve is joined to its beginning.
enum class Seam { open, closed };

/// One-sided rates compared at every interior key and, of a loop, where its end meets its beginning (key 0). A jump of
/// a rate of order k within 256 ε/h^k, h [s] being the smaller spacing beside the key, is rounding.
[[nodiscard]] ORISPLINE_EXPORT Continuity continuity_at_keys(const AnyCurve& curve, Seam seam = Seam::open);

}}  // namespace orispline
