// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_faults.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

/// A slow motion about one axis with a fast turn of 2 rad in half a second, from rest and back to rest, in which the
/// rate rises and falls evenly. Ten rates of the gyro a second miss the peak, which is between two of them.
struct FastTurn {
  static constexpr double from = 10.0, half = 0.25, peak = 8.0, half_window = 0.1;  // [s], [rad/s]

  /// By which the body has turned fast [rad].
  static double fast_angle(double t) {
    const double u = std::clamp((t - from) / half, 0.0, 2.0);
    return peak * half * (u <= 1.0 ? 0.5 * u * u : 1.0 - 0.5 * (2.0 - u) * (2.0 - u));
  }
  static double fast_rate(double t) { return peak * std::max(0.0, 1.0 - std::abs((t - from) / half - 1.0)); }
  static double angle(double t) { return 0.4 * std::sin(0.7 * t) + fast_angle(t); }
  static double rate(double t) { return 0.28 * std::cos(0.7 * t) + fast_rate(t); }

  FastTurn() {
    Dice dice(5);
    const auto about_axis = [](double x) { return Eigen::Vector3d(0.0, 0.0, x); };
    for (int i = 0; i <= 1500; ++i) {
      const double t = 0.02 * i, before = t - half_window, after = t + half_window;
      times.push_back(t);
      fitted.orientations.push_back(exp<double>(about_axis(angle(t))));
      orientations.push_back(fitted.orientations.back() * exp<double>(Eigen::Vector3d(noise * normal_vector(dice))));
      // Smooth as it is, the motion of the orientations by themselves has the mean rates of 0.2 s.
      fitted.angular_velocities.push_back(about_axis((angle(after) - angle(before)) / (after - before)));
      fitted.angular_accelerations.push_back(about_axis((rate(after) - rate(before)) / (after - before)));
    }
    for (int k = 0; k <= 300; ++k) {
      gyro.times.push_back(0.1 * k);
      gyro.rates.emplace_back(about_axis(rate(gyro.times.back())) + 0.01 * normal_vector(dice));
    }
  }
  [[nodiscard]] CountedRates left() const {
    CountedRates counts(gyro.times.size(), true);
    const SeenPoses poses{.times = times,
                          .orientations = orientations,
                          .counts = std::vector<bool>(times.size(), true),
                          .fitted = &fitted,
                          .noise = noise};
    const bool leaves_out = leave_out_faults(poses, gyro, {}, counts);
    EXPECT_EQ(leaves_out, std::ranges::count(counts, false) > 0);
    return counts;
  }

  static constexpr double noise = 0.002;
  std::vector<double> times{};
  std::vector<Eigen::Quaterniond> orientations{};
  SmoothedNodes fitted{};
  GyroRates gyro{.clock = GyroRates::Clock::own};
};

TEST(GyroFaults, AreNotWhatFewRatesMissInAFastTurn) {
  const FastTurn turn;
  double integrated = 0.0;
  for (std::size_t k = 99; k < 107; ++k) integrated += 0.1 * FastTurn::fast_rate(turn.gyro.times[k]);
  ASSERT_NEAR(FastTurn::fast_angle(11.0) - integrated, 0.08, 1e-9);  // forty times the noise
  EXPECT_EQ(std::ranges::count(turn.left(), false), 0);
}

TEST(GyroFaults, AreRatesThatMissMoreOfAFastTurnThanTheirNumberExplains) {
  FastTurn turn;
  for (std::size_t k = 101; k < 105; ++k) turn.gyro.rates[k] *= 0.9;
  const CountedRates counts = turn.left();
  for (std::size_t k = 101; k < 105; ++k) EXPECT_FALSE(counts[k]) << k;
  EXPECT_LT(std::ranges::count(counts, false), 9);
}

}}  // namespace orispline
