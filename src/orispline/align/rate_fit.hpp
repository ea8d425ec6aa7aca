// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/align/best_of_offsets.hpp>
#include <orispline/smooth/gyro_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a gyro is mounted beside another body and on its clock: ω_body(t) = B (ω_gyro(t + offset) + correction).
struct RateTransform {
  Eigen::Quaterniond body = Eigen::Quaterniond::Identity();  ///< B
  double offset = 0.0;                                       ///< [s]
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();      ///< [rad/s], in the frame of the gyro
};

/// Orientations beside which a gyro is seen, and how sure both are. Those to which rates lead are taken to be exact;
/// their noise is in `walk`.
struct RateFitData {
  const GyroRates& gyro;
  CountedRates counts{};                           ///< of the gyro
  std::vector<double> times{};                     ///< of the orientations [s]
  std::vector<Eigen::Quaterniond> orientations{};  ///< of the body in any world
  std::vector<std::size_t> pieces{};               ///< of orientations that have one world
  double noise = 0.0;                              ///< σ of the orientations per axis [rad]
  double walk = 0.0;                               ///< variance per axis of what rates lead wrong in 1 s [rad²/s]
  double gyro_noise = 0.0, gyro_interval = 0.0;    ///< σ of a rate per axis [rad/s]; [s]
  bool finds_body = true, finds_offset = true;
};

/// What the recordings cannot tell: so much of these together changes nothing.
struct OpenRateStep {
  Eigen::Vector3d body = Eigen::Vector3d::Zero();        ///< a turn of the body [rad]
  double offset = 0.0;                                   ///< [s]
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// A RateTransform of least robust squares, and what is known of it.
struct RateFit {
  RateTransform transform{};
  Eigen::Matrix3d body_covariance = Eigen::Matrix3d::Zero();  ///< of turns about the axes of the body [rad²]
  double offset_sigma = 0.0;                                  ///< [s]
  Eigen::Vector3d correction_sigma = Eigen::Vector3d::Zero();
  std::vector<OpenRateStep> open{};
  std::vector<std::size_t> compared{}, rejected{};  ///< orientations
  std::vector<double> distances{};                  ///< of each that was compared from where the gyro led [rad]
  std::vector<double> steps{};                      ///< which took so long [s]
  double usual = 0.0;                               ///< σ of such a distance per axis, as the noise has it [rad]
  double excess = 0.0;                              ///< robust, of the distances in units of that noise

  /// Minus twice a logarithm of the likelihood, but for a constant: less is better, also of fits that compare other
  /// numbers of orientations.
  [[nodiscard]] double cost() const;
  [[nodiscard]] TriedOffset tried() const { return {transform.offset, offset_sigma, excess * usual, distances.size()}; }
};

/// The least robust squares near to the guess; the rates, integrated from one orientation to the next, are compared
/// with the turns between the orientations, and what is known of where the gyro stands beside the world goes with them
/// (a Kalman filter, whose innovations are the residuals). None where fewer than `least_aligned` orientations overlap.
[[nodiscard]] std::optional<RateFit> fit_rates(const RateFitData& data, const RateTransform& guess);

}}  // namespace orispline
