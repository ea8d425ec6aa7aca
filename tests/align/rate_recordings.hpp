// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <orispline/align.hpp>

#include "smooth/gyro_motion.hpp"

// Gyros and orientations of one body that turns as in gyro_motion, with clocks, axes and biases of their own.

namespace orispline::rate_recordings {

/// What lies between a sensor and the body on whose clock the motion is: ω_body(t) = B (ω_sensor(t + late) − bias).
struct Sensor {
  Eigen::Quaterniond body = Eigen::Quaterniond::Identity();  // B
  double late = 0.0;                                         // [s]
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();            // [rad/s]
  double rate = 100.0, noise = 0.57 * degree;                // [Hz], per axis [rad/s] or [rad]
  double wild = 0.0;                                         // the share of samples that say anything
};

/// How a simulated body turns, and for how long.
struct SimulatedBody {
  explicit SimulatedBody(std::uint64_t seed) : about_all_axes(seed) {}

  gyro_motion::Motion about_all_axes;
  double duration = 60.0;                      // [s]
  std::optional<Eigen::Vector3d> only_axis{};  // then it swings about this one
  bool rests = false;

  [[nodiscard]] double angle(double t) const { return 1.1 * std::sin(1.9 * t) + 0.5 * std::sin(3.7 * t + 1.0); }
  [[nodiscard]] double angular_rate(double t) const {
    return 1.1 * 1.9 * std::cos(1.9 * t) + 0.5 * 3.7 * std::cos(3.7 * t + 1.0);
  }
  [[nodiscard]] Eigen::Quaterniond orientation(double t) const {
    if (rests) return Eigen::Quaterniond::Identity();
    return only_axis ? exp<double>(Eigen::Vector3d(angle(t) * *only_axis)) : about_all_axes.orientation(t);
  }
  [[nodiscard]] Eigen::Vector3d rate(double t) const {
    if (rests) return Eigen::Vector3d::Zero();
    return only_axis ? Eigen::Vector3d(angular_rate(t) * *only_axis) : about_all_axes.rate(t);
  }
};

inline GyroTrack gyro_of(const SimulatedBody& motion, const Sensor& sensor, std::uint64_t seed) {
  testing_support::Dice dice(seed);
  GyroTrack track;
  track.rates.clock = GyroRates::Clock::own;
  const auto count = static_cast<std::size_t>(motion.duration * sensor.rate);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / sensor.rate;
    const Eigen::Vector3d noise = sensor.noise * normal_vector(dice);
    const bool is_wild = dice.between(0.0, 1.0) < sensor.wild;
    const Eigen::Vector3d said = 20.0 * dice.vector();
    track.rates.times.push_back(t + sensor.late);
    track.rates.rates.emplace_back(
        is_wild ? said : Eigen::Vector3d(to_body<double>(sensor.body, motion.rate(t)) + sensor.bias + noise));
  }
  return track;
}

inline Track poses_of(const SimulatedBody& motion, const Sensor& sensor, std::uint64_t seed) {
  testing_support::Dice dice(seed);
  KeyframeData data;
  const auto count = static_cast<std::size_t>(motion.duration * sensor.rate);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / sensor.rate;
    const Eigen::Vector3d noise = sensor.noise * normal_vector(dice);
    const bool is_wild = dice.between(0.0, 1.0) < sensor.wild;
    const Eigen::Vector3d said = 1.5 * dice.vector();
    data.times.push_back(t + sensor.late);
    data.orientations.push_back(motion.orientation(t) * sensor.body * exp<double>(is_wild ? said : noise));
  }
  return Keyframes::make(std::move(data)).value();
}

/// A gyro that is mounted askew and runs late.
inline Sensor askew(std::uint64_t seed) {
  testing_support::Dice dice(1000 + seed);
  const Eigen::Vector3d turn = 1.2 * dice.vector();
  return {.body = exp<double>(turn), .late = dice.between(-0.3, 0.3), .bias = 2.0 * degree * dice.vector()};
}

}  // namespace orispline::rate_recordings
