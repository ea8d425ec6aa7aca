// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_path.hpp>

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace orispline { namespace {

Eigen::Vector3d cubic(double t) { return {1.0 + t * t * (0.3 - 0.02 * t), -t + 0.01 * t * t * t, 0.5 * t * t}; }

GyroPath path_through(const std::vector<double>& times) {
  GyroRates gyro{.times = times};
  for (const double t : times) gyro.rates.push_back(cubic(t));
  return {gyro, CountedRates(times.size(), true), Eigen::Vector3d::Zero()};
}

TEST(GyroPath, LaysACubicThroughFourRates) {
  const GyroPath path = path_through({0.0, 1.0, 2.5, 3.5, 4.0, 5.0});
  for (const double t : {1.0, 1.7, 2.6, 3.9}) EXPECT_LE((path.rate_at(t).value() - cubic(t)).norm(), 1e-14) << t;
  EXPECT_FALSE(path.rate_at(-0.1));
  EXPECT_FALSE(path.rate_at(5.1));
}

TEST(GyroPath, LaysALineAtTheEndsAndWhereIntervalsDifferMoreThanThreefold) {
  const GyroPath path = path_through({0.0, 1.0, 2.0, 5.2, 6.2, 7.2});
  for (const auto& [before, behind] : {std::pair{0.0, 1.0}, {1.0, 2.0}, {2.0, 5.2}, {5.2, 6.2}, {6.2, 7.2}}) {
    const Eigen::Vector3d quarter = 0.75 * cubic(before) + 0.25 * cubic(behind);
    EXPECT_LE((path.rate_at(0.75 * before + 0.25 * behind).value() - quarter).norm(), 1e-14) << before;
  }
}

}}  // namespace orispline
