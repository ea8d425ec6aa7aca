// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include <orispline/smooth/path_turns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How wrong rates and orientations are.
struct GyroNoises {
  double rate = 0.0;        ///< of the integrated rates: σ per axis after 1 s [rad]
  double drift = 0.0;       ///< of the bias: σ per axis of its change in 1 s [rad/s]; 0: it is constant
  double clock = 0.0;       ///< of the stamps: σ of the change of their offset in 1 s [s]; 0: they keep one clock
  double white = 0.0;       ///< of the orientations, per axis [rad]
  double correlated = 0.0;  ///< a first-order Markov part of the orientations' noise, per axis [rad]; 0: none
  double correlation_time = 0.0;  ///< within which that part falls to 1/e [s]

  [[nodiscard]] double pose() const { return std::sqrt(white * white + correlated * correlated); }
};

/// What a Kalman filter leaves of turns: squares and products of its innovations in units of their σ, those of the
/// turns first, then those of the slopes.
struct TurnInnovations {
  static constexpr int sides = 1 + calibration_columns::count;
  Eigen::Matrix<double, sides, sides> products = Eigen::Matrix<double, sides, sides>::Zero();
  double log_determinant = 0.0;  ///< of their covariances
};

/// A turn walks under the noise of the rates. Its states beside it: a change of the bias, the noise that correlates,
/// and a change of the offset of the clock, which no other one stands beside. Linear time.
[[nodiscard]] TurnInnovations filtered(std::span<const PathTurn> turns, const GyroNoises& noises);

/// -2 log of the likelihood of turns whose unknowns change by so much, but for a constant.
[[nodiscard]] double likelihood(std::span<const PathTurn> turns, const GyroNoises& noises,
                                const CalibrationUnknowns& change);

using CalibrationMatrix = Eigen::Matrix<double, calibration_columns::count, calibration_columns::count>;

/// Sum over the turns of the products of what of the slopes the best estimate of the turns, by those before and behind,
/// does not follow: by so much the orientations are off that are told with unknowns that are off. The clock keeps.
/// Linear time.
[[nodiscard]] CalibrationMatrix left_by_smoother(std::span<const PathTurn> turns, const GyroNoises& noises);

/// The unknowns that there are, by the standard deviations that are expected of them; 0: that one is zero. Nothing is
/// expected of the correction.
struct CalibrationPrior {
  double scale = 0.0, mount = 0.0, trend = 0.0, offset = 0.0, clock_rate = 0.0;

  [[nodiscard]] bool has(int column) const { return column < calibration_columns::scale || width(column) > 0.0; }
  [[nodiscard]] double width(int column) const;
};

struct FoundCalibration {
  double evidence = std::numeric_limits<double>::infinity();  ///< -2 log, the unknowns integrated out
  CalibrationUnknowns values = CalibrationUnknowns::Zero();
  CalibrationUnknowns sigmas = CalibrationUnknowns::Zero();
  CalibrationMatrix covariance = CalibrationMatrix::Zero();
};

/// Where the slopes were taken at `present`.
[[nodiscard]] FoundCalibration solved(const TurnInnovations& innovations, const CalibrationUnknowns& present,
                                      const CalibrationPrior& prior);

}}  // namespace orispline
