// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/smooth/gyro_model.hpp>

#include "smooth/gyro_motion.hpp"

namespace orispline::gyro_motion {

/// Orientations of a hand that turns, and the rates of a gyro with a clock of its own that this calibration brings to
/// the body.
struct GyroCase {
  explicit GyroCase(std::uint64_t seed, double seconds = 20.0, double pose_interval = 0.02)
      : motion(500 + seed), dice(600 + seed) {
    for (double t = 0.0; t < seconds; t += pose_interval) {
      data.times.push_back(t);
      data.orientations.push_back(motion.orientation(t));
    }
    for (double t = -0.05; t < seconds + 0.05; t += 0.01) gyro.times.push_back(t);
    gyro.clock = GyroRates::Clock::own;
    for (const double t : gyro.times) gyro.rates.push_back(motion.rate(t));
  }

  /// As the gyro would have it: `calibration` brings it back.
  void set_off(const GyroCalibration& calibration) {
    const double origin = calibration.origin, pace = 1.0 - calibration.clock_rate;
    for (std::size_t k = 0; k < gyro.rates.size(); ++k) {
      const Eigen::Vector3d added =
          calibration.correction + (gyro.times[k] + calibration.offset - origin) * calibration.trend;
      gyro.rates[k] = (calibration.shape.inverse() * (gyro.rates[k] - added)).eval();
    }
    for (double& t : gyro.times) t = (t + calibration.offset - calibration.clock_rate * origin) / pace;
  }
  void add_noise(double of_orientations, double of_rates) {
    for (Eigen::Quaterniond& q : data.orientations)
      q = q * exp<double>(Eigen::Vector3d(of_orientations * normal_vector(dice)));
    for (Eigen::Vector3d& rate : gyro.rates) rate += of_rates * normal_vector(dice);
  }

  [[nodiscard]] SeenPoses poses(double noise) const {
    return {.times = data.times,
            .orientations = data.orientations,
            .counts = std::vector<bool>(data.times.size(), true),
            .noise = noise};
  }
  [[nodiscard]] CountedRates counts() const { return CountedRates(gyro.times.size(), true); }

  Motion motion;
  Dice dice;
  KeyframeData data{};
  GyroRates gyro{};
};

}  // namespace orispline::gyro_motion
