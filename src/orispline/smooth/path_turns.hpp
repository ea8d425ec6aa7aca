// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/smooth/gyro_alignment.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What lies between the rates g of a gyro and those of a body: the body turns by
/// shape · g + correction + trend (t - origin) at the stamp t less offset + clock_rate (t - origin).
struct GyroCalibration {
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d trend = Eigen::Vector3d::Zero();       ///< of the correction [rad/s²]
  double offset = 0.0;                                   ///< [s]
  double clock_rate = 0.0;
  double origin = 0.0;  ///< [s]
};

/// The rates as those of the body, but for the constant correction, at stamps that keep the pace of the orientations.
[[nodiscard]] GyroRates calibrated(const GyroRates& gyro, const GyroCalibration& calibration);

/// The unknowns of a calibration, which move the turn between the path of a gyro and the world linearly.
namespace calibration_columns {
inline constexpr int correction = 0, scale = 3, mount = 6, cross = 9, trend = 12, offset = 15, clock_rate = 16,
                     count = 17;
}  // namespace calibration_columns
using CalibrationUnknowns = Eigen::Matrix<double, calibration_columns::count, 1>;

/// The shape with these scales, mount and cross-talk: I + scales + [mount]× + a symmetric matrix.
[[nodiscard]] Eigen::Matrix3d shape_of(const CalibrationUnknowns& unknowns);

/// How the world stands to the path of a gyro at an orientation: what it turned by is constant where the gyro and the
/// orientations are right.
struct PathTurn {
  bool starts = false;       ///< a piece of the path: what it turned by before is not known
  double interval = 0.0;     ///< since the orientation before [s]
  Eigen::Vector3d turn;      ///< of the path into the world, along the world's axes [rad], but for a constant
  Eigen::Matrix3d walked;    ///< by which a unit of correction moves it since the orientation before [s]
  Eigen::Matrix3d to_world;  ///< from the body
  Eigen::Matrix<double, 3, calibration_columns::count> slopes;  ///< by which the unknowns move it
  double share = 1.0;  ///< of the weight of the orientation over that of a usual one
};

/// At the orientations that count and that the path reaches.
[[nodiscard]] std::vector<PathTurn> path_turns(const SeenPoses& poses, const GyroRates& gyro,
                                               const CountedRates& counts, const GyroCalibration& calibration);

}}  // namespace orispline
