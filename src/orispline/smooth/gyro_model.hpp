// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/smooth/turn_filter.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A gyro as orientations see it, and how wrong both are.
struct GyroModel {
  GyroCalibration calibration{};
  GyroNoises noises{};
  bool has_scale = false, has_mount = false, has_trend = false, has_clock_rate = false;  ///< the recording tells them
  CalibrationUnknowns values = CalibrationUnknowns::Zero(), sigmas = CalibrationUnknowns::Zero();
  std::size_t seen = 0;  ///< orientations that the path of the gyro reaches
  /// Sum over these of the variances [rad²] that they have since the calibration is not known for sure, but for the
  /// correction by itself.
  double variance = 0.0;
  bool explains = true;  ///< the rates tell the turns better than none would, by a shape that a sensor may have
};

/// What is known beforehand.
struct GyroModelPlan {
  GyroCalibration near{};     ///< offset and correction about as they are
  double rate_noise = 0.0;    ///< at least, of the integrated rates: σ per axis after 1 s [rad]
  double pose_noise = 0.0;    ///< about, of the orientations, per axis [rad]
  bool finds_offset = false;  ///< else it stays
  bool finds_clock_rate = false, finds_trend = false;
  bool states_pose_noise = false;  ///< it is what it is, and white
  std::optional<GyroBias> bias{};  ///< absent: constant, unless a walk explains the recording better
};

/// The model of the greatest restricted likelihood of the turns between the path of the gyro and the world. No
/// smoothness of the motion takes part. A constant correction is always found; scale and mount, offset and rate of the
/// clock, a trend and a walk of the bias and noise that correlates are taken in where the likelihood gains more than
/// what was to be expected of them costs. Linear time. Our own derivation, docs/gyro.md.
[[nodiscard]] GyroModel gyro_model(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                   const GyroModelPlan& plan);

}}  // namespace orispline
