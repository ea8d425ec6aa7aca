// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/align/rate_alignment.hpp>
#include <orispline/align/rate_fit.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Turns of gyros are compared over this time [s] at least: a body moves evenly in it, and the noise of a rate is
/// little beside what it turns.
inline constexpr double least_turn_time = 0.05;

/// A gyro and what it says of the motion: orientations in a world of its own, which drift by its bias.
struct GyroMotion {
  CountedRates counts;  ///< but for single wild rates
  AnyCurve curve;
  double noise;     ///< σ of a rate per axis [rad/s]
  double interval;  ///< [s]

  /// Variance per axis of what the rates lead wrong in 1 s [rad²/s].
  [[nodiscard]] double walk() const noexcept { return noise * noise * interval; }
};

/// Error (bad_data): fewer than `least_aligned` rates, numbers that are not finite, times that do not increase.
[[nodiscard]] Expected<GyroMotion> gyro_motion(const GyroRates& gyro);

/// The fit of a gyro beside another one, to whose rates' turns of `least_turn_time` it is compared.
[[nodiscard]] RateFitData data_beside(const GyroRates& gyro, const GyroMotion& motion, const GyroRates& other,
                                      const GyroMotion& other_motion);

/// The rotation and the correction that suit an offset, near enough for fit_rates() to begin with. None where the
/// motions overlap by fewer than `least_aligned` intervals.
[[nodiscard]] std::optional<RateTransform> guess_rates(const AnyCurve& gyro, const AnyCurve& body, double interval,
                                                       double offset, bool finds_body);

/// What is left between the rates of both motions over intervals, in units of how they vary: near 0 for one motion,
/// about 1 for two. 0 where they do not overlap.
[[nodiscard]] double disagreement(const AnyCurve& gyro, const AnyCurve& body, double interval,
                                  const RateTransform& transform);

}}  // namespace orispline
