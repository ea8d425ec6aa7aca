// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smooth.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline {

using testing_support::Dice;

inline constexpr double degree = 0.017453292519943295;

/// Nearly normal: the sum of twelve uniform variables in [-½, ½].
inline Eigen::Vector3d normal_vector(Dice& dice) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 12; ++k) sum += 0.5 * dice.vector();
  return sum;
}

struct Recording {
  KeyframeData clean{}, noisy{};
};

/// Turns about two axes at 100 Hz with noise of σ per axis.
inline Recording recorded(std::size_t count, double noise, std::uint64_t seed = 7) {
  Recording recording;
  Dice dice(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.0, 0.0, std::sin(2.0 * t))) *
                                 exp<double>(Eigen::Vector3d(std::sin(3.0 * t), 0.0, 0.0));
    recording.clean.times.push_back(t);
    recording.clean.orientations.push_back(q);
    recording.noisy.orientations.push_back(q * exp<double>(Eigen::Vector3d(noise * normal_vector(dice))));
  }
  recording.noisy.times = recording.clean.times;
  return recording;
}

/// A motion that the penalty is the prior of: body rates that are a random walk, of 2 rad/s in a second, at 100 Hz.
inline Recording wandering(std::size_t count, double noise, std::uint64_t seed) {
  constexpr int steps = 10;  // of the walk, from sample to sample
  Recording recording;
  Dice dice(100 + seed);
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    recording.clean.times.push_back(0.01 * static_cast<double>(i));
    recording.clean.orientations.push_back(q);
    recording.clean.angular_velocities.push_back(rate);
    recording.noisy.orientations.push_back(q * exp<double>(Eigen::Vector3d(noise * normal_vector(dice))));
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector3d half = rate;
      rate += 2.0 * std::sqrt(0.01 / steps) * normal_vector(dice);
      q = (q * exp<double>(Eigen::Vector3d(0.01 / steps * 0.5 * (half + rate)))).normalized();
    }
  }
  recording.noisy.times = recording.clean.times;
  return recording;
}

inline Smoothing smoothed(const KeyframeData& data, const SmoothOptions& options = {}) {
  return smooth(Keyframes::make(data).value(), options).value();
}

inline double rms(const Smoothing& smoothing, const KeyframeData& clean) {
  double sum = 0.0;
  for (std::size_t k = 0; k < smoothing.keys.size(); ++k) {
    const double d = angular_distance(smoothing.nodes.orientations[k], clean.orientations[smoothing.keys[k]]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(smoothing.keys.size()));
}

}  // namespace orispline
