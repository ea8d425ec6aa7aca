// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/smooth/gyro_alignment.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Rates as a sensor meant them.
struct RepairedGyro {
  /// Of rates beside orientations. Stamps of a clock of its own that come in batches, most of them within a small part
  /// of the time that they span, are spread evenly over the time since the batch before. Counters that come round, by
  /// which successive rates differ by nearly their whole range again and again, are unwound. An axis whose rates are
  /// all the same to the last bit, though the orientations turn about it, takes the rates of these.
  RepairedGyro(const GyroRates& gyro, const SeenPoses& poses);

  GyroRates rates;
  bool came_in_batches = false;
  std::array<bool, 3> unwound_axes{}, dead_axes{};
  Eigen::Matrix3d mount = Eigen::Matrix3d::Identity();  ///< from the axes of the sensor to those of the body

  [[nodiscard]] bool has_dead_axis() const { return dead_axes[0] || dead_axes[1] || dead_axes[2]; }
};

/// Closes the gaps between stamps behind which the orientations say that the clock jumped, so that no rate is missing
/// there: the largest ones are tried, by the likelihood of the turns between path and world. Of rates with a clock of
/// their own. `rate_noise`: of the integrated rates, σ per axis after 1 s [rad].
[[nodiscard]] std::vector<GyroFinding::ClockJump> close_jumps(GyroRates& gyro, const SeenPoses& poses,
                                                              const CountedRates& counts,
                                                              const GyroAlignment& alignment, double rate_noise);

}}  // namespace orispline
