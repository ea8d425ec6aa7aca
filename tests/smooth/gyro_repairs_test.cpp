// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_repairs.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "smooth/gyro_case.hpp"

namespace orispline::gyro_motion { namespace {

/// Beside orientations whose smooth motion is the true one.
struct Repairs {
  explicit Repairs(std::uint64_t seed, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> turned = {})
      : made(seed, 10.0, 0.01) {
    made.gyro.times.clear();
    made.gyro.rates.clear();
    for (const double t : made.data.times) {
      const double step = 1e-4;
      const auto rate = [&](double at) { return turned ? turned(made.motion.rate(at)) : made.motion.rate(at); };
      fitted.angular_velocities.push_back(rate(t));
      fitted.angular_accelerations.emplace_back((rate(t + step) - rate(t - step)) / (2.0 * step));
      made.gyro.times.push_back(t);
      made.gyro.rates.emplace_back(rate(t) + 0.3 * degree * normal_vector(made.dice));
    }
    fitted.orientations = made.data.orientations;
  }

  [[nodiscard]] RepairedGyro repaired() const {
    SeenPoses poses = made.poses(0.5 * degree);
    poses.fitted = &fitted;
    return RepairedGyro(made.gyro, poses);
  }
  void expect_untouched(const char* what) const {
    const RepairedGyro gyro = repaired();
    EXPECT_EQ(gyro.rates.times, made.gyro.times) << what;
    EXPECT_EQ(gyro.rates.rates, made.gyro.rates) << what;
    EXPECT_FALSE(gyro.came_in_batches || gyro.has_dead_axis()) << what;
    EXPECT_EQ(gyro.unwound_axes, (std::array<bool, 3>{})) << what;
  }

  GyroCase made;
  SmoothedNodes fitted{};
};

TEST(GyroRepairs, LeaveGoodRatesAsTheyAre) {
  Repairs good(1);
  good.expect_untouched("noisy");
  Repairs quantised(2);
  for (Eigen::Vector3d& rate : quantised.made.gyro.rates) rate = (rate * 20.0).array().round() / 20.0;
  quantised.expect_untouched("quantised");
  Repairs planar(3, [](const Eigen::Vector3d& rate) { return Eigen::Vector3d(0.0, 0.0, rate.z()); });
  for (Eigen::Vector3d& rate : planar.made.gyro.rates) rate.head<2>().setZero();
  planar.expect_untouched("planar, two axes of zeros");
  Repairs rests(4);
  for (std::size_t k = 400; k < 700; ++k) {
    rests.made.gyro.rates[k] = rests.made.gyro.rates[400];
    rests.fitted.angular_velocities[k].setZero();
  }
  rests.expect_untouched("rests");
  Repairs jittered(5);
  for (double& t : jittered.made.gyro.times) t += jittered.made.dice.between(-0.004, 0.004);
  jittered.expect_untouched("uneven stamps");
  Repairs spikes(6);
  for (const std::size_t k : {100u, 300u, 301u, 800u}) spikes.made.gyro.rates[k].x() += 35.0;
  spikes.expect_untouched("spikes");
}

TEST(GyroRepairs, SpreadBatchesOfStamps) {
  Repairs batches(7);
  constexpr std::size_t size = 10;
  std::vector<double>& times = batches.made.gyro.times;
  times.resize(times.size() / size * size);
  batches.made.gyro.rates.resize(times.size());
  const std::vector<double> wanted = times;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    times[k] = wanted[k / size * size + size - 1] + 1e-5 * static_cast<double>(k % size) - 9e-5;
  const RepairedGyro gyro = batches.repaired();
  EXPECT_TRUE(gyro.came_in_batches);
  EXPECT_EQ(gyro.rates.rates, batches.made.gyro.rates);
  for (std::size_t k = 0; k < wanted.size();
       ++k)  // how long the first batch lasted is known from the mean interval only
    EXPECT_NEAR(gyro.rates.times[k], wanted[k], k < size ? 1e-3 : 1e-4) << k;
}

TEST(GyroRepairs, UnwindCounters) {
  Repairs wound(8);
  const auto good = wound.made.gyro.rates;
  double most = 0.0;
  for (const Eigen::Vector3d& rate : good) most = std::max(most, 0.6 * std::abs(rate.y()));
  for (Eigen::Vector3d& rate : wound.made.gyro.rates) rate.y() = std::remainder(rate.y(), 2.0 * most);
  const RepairedGyro gyro = wound.repaired();
  EXPECT_EQ(gyro.unwound_axes, (std::array{false, true, false}));
  double squares = 0.0;
  for (std::size_t k = 0; k < good.size(); ++k) squares += (gyro.rates.rates[k] - good[k]).squaredNorm();
  EXPECT_LT(std::sqrt(squares / static_cast<double>(good.size())), 0.3 * degree);
}

TEST(GyroRepairs, FindDeadAxes) {
  Repairs dead(9);
  for (Eigen::Vector3d& rate : dead.made.gyro.rates) rate.x() = 0.25;
  const RepairedGyro gyro = dead.repaired();
  EXPECT_EQ(gyro.dead_axes, (std::array{true, false, false}));
  for (std::size_t k = 0; k < gyro.rates.rates.size(); ++k) {
    EXPECT_NEAR(gyro.rates.rates[k].x(), dead.fitted.angular_velocities[k].x(), 1e-12);
    EXPECT_EQ(gyro.rates.rates[k].tail<2>(), dead.made.gyro.rates[k].tail<2>());
  }
}

}}  // namespace orispline::gyro_motion
