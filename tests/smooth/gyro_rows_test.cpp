// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_rows.hpp>

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

/// Turns about one axis ever faster; the gyro speaks between some of the orientations only.
struct Spin {
  static constexpr std::array<std::pair<std::size_t, std::size_t>, 2> spoken{{{8, 18}, {26, 30}}};
  static constexpr double late = 0.25;
  Eigen::Vector3d axis{0.48, -0.6, 0.64}, correction{0.02, -0.03, 0.01};
  KeyframeData data{};
  GyroRates gyro{.clock = GyroRates::Clock::own};

  static double angle(double t) { return t * (12.0 + 0.5 * t); }
  static double rate(double t) { return 12.0 + t; }
  [[nodiscard]] bool speaks(double t) const {
    return std::ranges::any_of(
        spoken, [&](const auto& part) { return t >= data.times[part.first] && t <= data.times[part.second]; });
  }

  Spin() {
    const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(1.0, 2.0, -0.5));
    for (int i = 0; i < 36; ++i) {  // in turn 0.08 s and 0.15 s apart, in which it turns by up to 2.4 rad
      data.times.push_back(0.23 * (i / 2) + (i % 2 == 0 ? 0.0 : 0.08));
      data.orientations.push_back(world * exp<double>(Eigen::Vector3d(angle(data.times.back()) * axis)));
    }
    for (const auto& [first, last] : spoken) {
      const double from = data.times[first], to = data.times[last], count = std::round((to - from) / 0.01);
      for (double k = 0.0; k <= count; k += 1.0) {
        const double t = k < count ? from + k / count * (to - from) : to;
        gyro.times.push_back(t + late);
        gyro.rates.emplace_back(rate(t) * axis - correction);
      }
    }
  }
  [[nodiscard]] GyroRows rows() const {
    const SeenPoses poses{.times = data.times,
                          .orientations = data.orientations,
                          .counts = std::vector<bool>(data.times.size(), true),
                          .noise = 0.01};
    return rows_of(poses, gyro, CountedRates(gyro.times.size(), true), 0.01,
                   {.offset = late, .correction = correction});
  }
};

TEST(GyroRows, BeginWithTheRatesOfTheOrientationsBesideWhereTheGyroSaysNothing) {
  const Spin spin;
  const GyroRows rows = spin.rows();
  const std::vector<double>& times = rows.problem.times;
  ASSERT_EQ(rows.start.angular_velocities.size(), times.size());
  std::size_t silent = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double before = times[i == 0 ? 0 : i - 1], after = times[std::min(i + 1, times.size() - 1)];
    const bool speaks = spin.speaks(times[i]);
    const double wanted = speaks ? Spin::rate(times[i]) : (Spin::angle(after) - Spin::angle(before)) / (after - before);
    EXPECT_LT((rows.start.angular_velocities[i] - wanted * spin.axis).norm(), 1e-9) << times[i];
    silent += speaks ? 0 : 1;
  }
  EXPECT_EQ(silent, 8u + 7u + 5u);
}

}}  // namespace orispline
