// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <gtest/gtest.h>
#include <random>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

TEST(Retime, LimitsTheJerk) {
  const Keyframes slew = turning([](double u) { return 2.0 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u)); }, 24);
  const double jerk = sampled(make_curve("auto", slew).value()).jerk;
  EXPECT_NEAR(retimed("auto", slew, {.jerk = jerk / 125.0}).time_scale, 5.0, 1e-3);
  const Keyframes keys = random_keys(31, {12, 2.0, 20.0});
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const Retiming slow = retimed("timed-c2", keys, {.rate = 1.0, .jerk = 8.0}, slowing);
    const MotionSizes peaks = sampled(curve_of("timed-c2", slow));
    EXPECT_LE(peaks.rate, 1.0);
    EXPECT_LE(peaks.jerk, 8.0);
  }
  EXPECT_EQ(
      error("timed-c1", keys, {.jerk = 1.0}),
      "timed-c1: its angular acceleration jumps at keys, which no slowing brings within a limit of jerk, wanted a "
      "method that is C2, such as auto");
}

TEST(Retime, LimitsComponentsAboutTheAxes) {
  const Keyframes keys = random_keys(32, {12, 2.0, 20.0});
  const Eigen::Vector3d most(0.5, 0.8, 1.1);
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const Retiming slow = retimed("auto", keys, {.rate = most}, slowing);
    const AnyCurve curve = curve_of("auto", slow);
    double used = 0.0;
    for (int i = 0; i <= 20000; ++i) {
      const auto [start, end] = curve.domain();
      used = std::max(
          used,
          curve.motion(start + i * (end - start) / 20000).angular_velocity.cwiseQuotient(most).cwiseAbs().maxCoeff());
    }
    EXPECT_LE(used, 1.0);
    EXPECT_GE(used, 1.0 - 3e-3);
  }
}

TEST(Retime, LimitsThePosition) {
  const Keyframes turning_keys = random_keys(33, {10, 1.0, 10.0});
  KeyframeData data{.times = {turning_keys.times().begin(), turning_keys.times().end()},
                    .orientations = {turning_keys.orientations().begin(), turning_keys.orientations().end()}};
  std::mt19937 random(33);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (std::size_t i = 0; i < data.times.size(); ++i)
    data.positions.emplace_back(place(random), place(random), place(random));
  const Keyframes keys = Keyframes::make(data).value();
  const Retiming slow = retimed("auto", keys, {.speed = 0.2, .linear_acceleration = 0.1});
  const PoseCurve curve = make_pose_curve("auto", slow.track.keys).value();
  double speed = 0.0, acceleration = 0.0;
  for (int i = 0; i <= 40000; ++i) {
    const LinearMotion m =
        curve.position->linear_motion(slow.track.keys.times().back() * static_cast<double>(i) / 40000.0);
    speed = std::max(speed, m.velocity.norm());
    acceleration = std::max(acceleration, m.acceleration.norm());
  }
  EXPECT_LE(speed, 0.2);
  EXPECT_LE(acceleration, 0.1);
  EXPECT_GE(std::max(speed / 0.2, acceleration / 0.1), 1.0 - 1e-3);
  EXPECT_EQ(error("auto", turning_keys, {.speed = 1.0}),
            "max_speed: the keys have no positions, wanted px,py,pz as well");
}

}}  // namespace orispline
