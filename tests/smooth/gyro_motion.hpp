// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "smooth/noisy_motion.hpp"

// A gyro and poses of a hand that turns, and what gyros do wrong.

namespace orispline::gyro_motion {

/// Turns about three axes, each a sum of three sines of 0.2 to 1 Hz; 50 to 65 °/s RMS an axis.
class Motion {
 public:
  explicit Motion(std::uint64_t seed) {
    Dice dice(seed);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double rms = dice.between(50.0, 65.0) * degree;
      for (Eigen::Index k = 0; k < 3; ++k) {
        frequencies_(axis, k) = 2.0 * testing_support::pi *
                                dice.between(0.2 + 0.3 * static_cast<double>(k), 0.5 + 0.25 * static_cast<double>(k));
        phases_(axis, k) = dice.between(-3.0, 3.0);
        amplitudes_(axis, k) = rms * std::sqrt(2.0 / 3.0) / frequencies_(axis, k);
      }
    }
  }

  [[nodiscard]] Eigen::Quaterniond orientation(double t) const { return exp<double>(turn(t)); }
  /// [rad/s], body frame
  [[nodiscard]] Eigen::Vector3d rate(double t) const {
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (Eigen::Index k = 0; k < 3; ++k)
        slope[axis] +=
            amplitudes_(axis, k) * frequencies_(axis, k) * std::cos(frequencies_(axis, k) * t + phases_(axis, k));
    return right_jacobian<double>(turn(t)) * slope;
  }

 private:
  [[nodiscard]] Eigen::Vector3d turn(double t) const {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (Eigen::Index k = 0; k < 3; ++k)
        turn[axis] += amplitudes_(axis, k) * std::sin(frequencies_(axis, k) * t + phases_(axis, k));
    return turn;
  }

  Eigen::Matrix3d frequencies_, phases_, amplitudes_;
};

struct Recorded {
  KeyframeData clean{}, noisy{};
};

/// 20 s at 100 Hz, with noise of 0.5° and 0.57 °/s per axis, a bias, and stamps of the gyro that are late [s].
inline Recorded recorded(std::uint64_t seed, double late = 0.0, std::size_t count = 2000) {
  const Motion motion(100 + seed);
  Dice dice(200 + seed);
  const Eigen::Vector3d bias = degree * dice.vector();
  Recorded recorded;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    recorded.clean.times.push_back(t);
    recorded.clean.orientations.push_back(motion.orientation(t));
    recorded.noisy.orientations.push_back(recorded.clean.orientations.back() *
                                          exp<double>(Eigen::Vector3d(0.5 * degree * normal_vector(dice))));
    recorded.noisy.angular_velocities.emplace_back(motion.rate(t - late) + bias + 0.57 * degree * normal_vector(dice));
  }
  recorded.noisy.times = recorded.clean.times;
  return recorded;
}

}  // namespace orispline::gyro_motion
