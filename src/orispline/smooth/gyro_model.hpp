// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/gyro_alignment.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What lies between the rates g of a gyro and those of a body: the body turns by shape · g + correction at the stamp t
/// less offset + clock_rate (t - clock_origin).
struct GyroCalibration {
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();  ///< [rad/s]
  double offset = 0.0;                                   ///< [s]
  double clock_rate = 0.0;
  double clock_origin = 0.0;  ///< [s]
};

/// How wrong rates and orientations are.
struct GyroNoises {
  double rate = 0.0;        ///< of the integrated rates, per axis in the root of 1 s [rad/√s]
  double drift = 0.0;       ///< of the bias: σ per axis of its change in 1 s [rad/s]; 0: it is constant
  double white = 0.0;       ///< of the orientations, per axis [rad]
  double correlated = 0.0;  ///< their part that keeps for a time, per axis [rad]; 0: there is none
  double clock = 0.0;       ///< of the stamps: σ of the change of their offset in 1 s [s]; 0: it is one
  double time = 0.0;        ///< of that part: within it, it falls to 1/e [s]
};

/// A gyro as orientations see it, with the standard deviations of what was found.
struct GyroModel {
  GyroCalibration calibration{};
  GyroNoises noises{};
  bool has_scale = false, has_mount = false, has_clock_rate = false;  ///< which parts the recording tells
  Eigen::Vector3d scale_sigma = Eigen::Vector3d::Zero(), mount_sigma = Eigen::Vector3d::Zero();
  double offset_sigma = 0.0, clock_rate_sigma = 0.0;
  std::size_t seen = 0;  ///< orientations that the rates lead to
};

/// What is known beforehand.
struct GyroModelPlan {
  GyroCalibration near{};     ///< offset and correction about as they are
  double rate_noise = 0.0;    ///< at least [rad/√s]
  double pose_noise = 0.0;    ///< about [rad]
  bool finds_offset = false;  ///< else it stays
  bool finds_clock_rate = false;
  bool states_noise = false;  ///< `pose_noise` is what it is
  bool constant_bias = false, drifting_bias = false;  ///< as stated
};

/// The model of greatest restricted likelihood. The turn between the integrated rates and the orientations is a random
/// walk under the noise of the rates; correction, scale, mount and clock move it linearly, a bias that drifts and noise
/// that keeps are states of a Kalman filter over the orientations. No smoothness of the motion takes part. Scale, mount
/// and clock rate are taken in where the likelihood gains more by them than their prior widths cost. Linear time. Our
/// own derivation, docs/gyro.md.
[[nodiscard]] GyroModel gyro_model(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                   const GyroModelPlan& plan);

/// The rates as the body's, but for the correction, at stamps whose clock keeps the pace of the orientations.
[[nodiscard]] GyroRates calibrated(const GyroRates& gyro, const GyroCalibration& calibration);

}}  // namespace orispline
