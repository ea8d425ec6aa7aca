// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/smooth/gyro_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Orientations beside which a gyro is seen.
struct SeenPoses {
  std::span<const double> times{};                     ///< [s]
  std::span<const Eigen::Quaterniond> orientations{};  ///< as recorded
  std::vector<bool> counts{};                          ///< which of them are no outliers
  const SmoothedNodes* fitted = nullptr;               ///< the smooth motion that they have by themselves
  double noise = 0.0;                                  ///< of a usual one of them, per axis [rad]
  std::span<const double> shares{};                    ///< as of SmoothingProblem
};

/// The rate of the motion that orientations have by themselves [rad/s], the cubic between two of them; nothing beside
/// them.
[[nodiscard]] std::optional<Eigen::Vector3d> rate_of_poses(const SeenPoses& poses, double t);

/// How a gyro stands to orientations: its stamp less `offset` is the time on their clock, and its rate plus
/// `correction` is that of the body.
struct GyroAlignment {
  double offset = 0.0;                                   ///< [s]
  std::optional<double> offset_sigma{};                  ///< [s]; absent where the motion does not tell it
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// The offset, to about an interval, under which rates and orientations agree best, of a quarter of the recording and
/// 5 s at most; 0 where that is about as good. A tenth of the rates may be wrong.
[[nodiscard]] double coarse_offset(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts);

/// From an alignment that is near: what the rates, integrated between orientations, say about the orientations without
/// the help of any smoothness. Gauss–Newton over windows that are about as long as the gyro is surer than the
/// orientations, each with an orientation of its own, with Huber's weights. `finds_offset`: else it stays as it is.
[[nodiscard]] GyroAlignment aligned(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                    double gyro_noise, GyroAlignment near, bool finds_offset);

}}  // namespace orispline
