// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <orispline/math/degrees.hpp>

#include "retime/retimed_motion.hpp"
#include "support/follower.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

double angle_between(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q) { return increment(p, q).norm(); }

TEST(Retime, UniformSlowingKeepsThePathAndScalesTheRates) {
  const Keyframes keys = random_keys(11, {8, 2.0, 20.0});
  for (const std::string_view method : {"auto", "timed-c2", "timed-sextic", "rotation-spline"}) {
    const AnyCurve before = make_curve(method, keys).value();
    const MotionSizes peaks = sampled(before);
    for (const MotionLimits& limits :
         {MotionLimits{.rate = peaks.rate / 3.0}, MotionLimits{.acceleration = peaks.acceleration / 9.0},
          MotionLimits{.torque = peaks.torque / 9.0, .inertia = inertia}}) {
      const Retiming slow = retimed(method, keys, limits);
      EXPECT_NEAR(slow.time_scale / 3.0, 1.0, 1e-4) << method;
      EXPECT_GE(slow.time_scale, 3.0 * (1.0 - 1e-6)) << method;
      const AnyCurve after = curve_of(method, slow);
      for (const double t : {0.3, 2.2, 5.0}) {
        const Motion a = before.motion(t), b = after.motion(slow.time_scale * t);
        EXPECT_LE(angle_between(a.orientation, b.orientation), 1e-7);
        EXPECT_LE((a.angular_velocity - slow.time_scale * b.angular_velocity).norm(), 1e-7 * peaks.rate);
        EXPECT_LE((a.angular_acceleration - slow.time_scale * slow.time_scale * b.angular_acceleration).norm(),
                  1e-7 * peaks.acceleration);
      }
    }
  }
}

TEST(Retime, FindsTheSlowingOfTurnsInClosedForm) {
  const Keyframes quarter = turning([](double u) { return 0.5 * std::numbers::pi * u; }, 1);
  EXPECT_NEAR(retimed("slerp", quarter, {.rate = 0.1 * std::numbers::pi}).time_scale, 5.0, 5e-4);
  // Rest to rest by 2 rad in 1 s: the largest ω is 15/8 · 2, the largest α is 10/√3 · 2.
  const Keyframes slew = turning([](double u) { return 2.0 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u)); }, 24);
  EXPECT_NEAR(retimed("auto", slew, {.rate = 15.0 / 4.0 / 7.0}).time_scale, 7.0, 7e-4);
  EXPECT_NEAR(retimed("auto", slew, {.acceleration = 20.0 / std::numbers::sqrt3 / 49.0}).time_scale, 7.0, 7e-4);
  // A ball of 3 kg m² about one axis.
  const MotionLimits ball{.torque = 60.0 / std::numbers::sqrt3 / 49.0, .inertia = 3.0 * Eigen::Matrix3d::Identity()};
  EXPECT_NEAR(retimed("auto", slew, ball).time_scale, 7.0, 7e-4);
}

TEST(Retime, LeavesAMotionWithinItsLimitsAsItIs) {
  const Keyframes keys = random_keys(2, {7, 1.5, 5.0});
  const auto peaks = certified(make_curve("auto", keys).value(), {}, {1e-9, 1e-9, 1e-9, 1e-9}).value();
  double bound = 0.0;
  for (const TurningPeaks& segment : peaks) bound = std::max(bound, segment.rate.bound);
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const Retiming same = retimed("auto", keys, {.rate = bound * (1.0 + 1e-4)}, slowing);
    EXPECT_EQ(same.time_scale, 1.0);
    EXPECT_TRUE(std::ranges::equal(same.track.keys.times(), keys.times()));
  }
}

TEST(Retime, DependsNeitherOnTheOriginOfTimeNorOnSigns) {
  const Keyframes keys = random_keys(21, {9, 1.5, 5.0});
  std::vector<double> late;
  for (const double t : keys.times()) late.push_back(1.7e9 + t);
  KeyframeData flipped{.times = {keys.times().begin(), keys.times().end()}};
  for (std::size_t i = 0; i < keys.size(); ++i)
    flipped.orientations.emplace_back((i % 3 == 0 ? -1.0 : 1.0) * keys.orientations()[i].coeffs());
  const MotionLimits limits{.rate = 0.5, .acceleration = 0.6};
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const double time_scale = retimed("auto", keys, limits, slowing).time_scale;
    const Retiming shifted = retimed("auto", at_times(keys, late), limits, slowing);
    EXPECT_NEAR(shifted.time_scale / time_scale, 1.0, slowing == Slowing::uniform ? 1e-4 : 2e-3);
    EXPECT_EQ(shifted.track.keys.times().front(), late.front());
    EXPECT_NEAR(retimed("auto", Keyframes::make(flipped).value(), limits, slowing).time_scale / time_scale, 1.0, 1e-9);
  }
}

TEST(Retime, StaysWithinTheLimitsAndReachesOneOfThem) {
  const MotionLimits limits{.rate = 1.0, .acceleration = 2.0, .torque = 3.0, .inertia = inertia};
  unsigned seed = 30;
  for (const std::string_view method : {"auto", "timed-c1", "timed-c3", "bspline"})
    for (const KeyDrawing how : {KeyDrawing{12, 2.9, 100.0}, KeyDrawing{3, 1.0}, KeyDrawing{2, 3.0}}) {
      const Keyframes keys = random_keys(++seed, how);
      const Retiming uniform = retimed(method, keys, limits);
      const Retiming separate = retimed(method, keys, limits, Slowing::per_interval);
      EXPECT_LE(separate.time_scale, uniform.time_scale);
      for (const Retiming* retiming : {&uniform, &separate}) {
        const MotionSizes peaks = sampled(curve_of(method, *retiming));
        EXPECT_LE(peaks.rate, 1.0) << method;
        EXPECT_LE(peaks.acceleration, 2.0) << method;
        EXPECT_LE(peaks.torque, 3.0) << method;
        for (std::size_t i = 0; i + 1 < keys.size(); ++i)
          EXPECT_GE(retiming->track.keys.times()[i + 1] - retiming->track.keys.times()[i],
                    (keys.times()[i + 1] - keys.times()[i]) * (1 - 1e-12));
      }
      const MotionSizes peaks = sampled(curve_of(method, uniform));
      if (uniform.time_scale > 1.0) {
        EXPECT_GE(std::max({peaks.rate, peaks.acceleration / 2.0, peaks.torque / 3.0}), 1.0 - 3e-4);
      }
    }
}

TEST(Retime, IntervalsOfGeodesicsTakeWhatTheyMust) {
  const Keyframes keys = random_keys(4, {40, 2.5, 30.0});
  const Retiming slow = retimed("slerp", keys, {.rate = 1.0}, Slowing::per_interval);
  double least = 0.0;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    least += std::max(keys.times()[i + 1] - keys.times()[i],
                      angle_between(keys.orientations()[i], keys.orientations()[i + 1]));
  EXPECT_GE(slow.track.keys.times().back(), least);
  EXPECT_LE(slow.track.keys.times().back(), least * 1.002);
}

TEST(Retime, SaysHowItSlowed) {
  const Keyframes keys = random_keys(4, {40, 2.5, 30.0}), steady = turning([](double u) { return u; }, 4);
  EXPECT_EQ(retimed("slerp", keys, {.rate = 1.0}, Slowing::uniform).slowing, Slowing::uniform);
  EXPECT_EQ(retimed("slerp", keys, {.rate = 1.0}, Slowing::per_interval).slowing, Slowing::per_interval);
  EXPECT_EQ(retimed("slerp", steady, {.rate = 0.1}, Slowing::per_interval).slowing, Slowing::uniform);
}

TEST(Retime, KeepsItsPromiseWhereStepsDifferByAMillionAndMore) {
  const Keyframes five = at_times(random_keys(2, {5, 1.5}), {0.0, 1.0, 1.0 + 1e-6, 2.0, 3.0});
  for (const Keyframes& keys : {five, random_keys(2, {11, 1.5, 1e9})})
    for (const std::string_view method : {"timed-c1", "timed-c2", "timed-c3", "auto"}) {
      const Retiming slow = retimed(method, keys, {.rate = 90.0 * radians_per_degree});
      EXPECT_LE(slow.slack, 2e-4) << method;
      EXPECT_FALSE(is_warned_of(slow, "loose_bounds")) << method;
      const double rate = sampled(curve_of(method, slow)).rate / (90.0 * radians_per_degree);
      EXPECT_LE(rate, 1.0) << method;
      EXPECT_GE(rate, 1.0 - 1e-2) << method;
      const Retiming gentle = retimed(method, five, {.acceleration = 200.0 * radians_per_degree});
      EXPECT_LE(gentle.slack, 2e-4) << method;
      EXPECT_GE(sampled(curve_of(method, gentle)).acceleration, (1.0 - 1e-2) * 200.0 * radians_per_degree) << method;
    }
}

TEST(Retime, RefusesLimitsThatAreNone) {
  const Keyframes keys = random_keys(1, {4, 1.0});
  EXPECT_EQ(error("auto", keys, {}),
            "found no limit, wanted `max_rate`, `max_acceleration`, `max_jerk`, `max_torque`, `max_speed`, "
            "`max_linear_acceleration`, `duration`, `constant_rate` or `constant_speed`");
  EXPECT_EQ(error("auto", keys, {.rate = 0.0}), "max_rate: found 0 rad/s, wanted more than 0 rad/s");
  EXPECT_EQ(error("auto", keys, {.acceleration = -2.0}),
            "max_acceleration: found -2 rad/s², wanted more than 0 rad/s²");
  EXPECT_EQ(error("auto", keys, {.rate = std::numeric_limits<double>::infinity()}),
            "max_rate: found inf rad/s, wanted more than 0 rad/s and finite");
  EXPECT_EQ(error("auto", keys, {.rate = std::numeric_limits<double>::quiet_NaN()}),
            "max_rate: found nan rad/s, wanted more than 0 rad/s");
  EXPECT_EQ(error("auto", keys, {.torque = 1.0}),
            "max_torque: the torque depends on the body, wanted `inertia` as well");
  EXPECT_EQ(error("auto", keys, {.rate = 1.0, .inertia = Eigen::Matrix3d::Identity()}),
            "inertia: it is used for the torque alone, wanted `max_torque` as well");
  const Eigen::Matrix3d indefinite = Eigen::Vector3d(1.0, -2.0, 3.0).asDiagonal();
  EXPECT_EQ(error("auto", keys, {.torque = 1.0, .inertia = indefinite}),
            "inertia: found the principal moments -2, 1, 3, wanted all of them greater than 0");
  for (const double limit : {1e-100, 5e-324})
    EXPECT_TRUE(error("auto", keys, {.rate = limit}).ends_with(", wanted limits that 1e+15 meets"));
}

TEST(Retime, RefusesMethodsThatNoSlowingHelps) {
  const Keyframes keys = random_keys(1, {4, 1.0});
  EXPECT_EQ(error("slerp", keys, {.acceleration = 1.0}),
            "slerp: its angular velocity jumps at keys, which no slowing brings within a limit of acceleration or "
            "torque, wanted a method that is C1, such as auto");
  EXPECT_EQ(error("squad", keys, {.rate = 1e-3}),
            "squad: no bounds are known for the segments of this method, wanted one of polynomials, such as auto or "
            "timed-c2");
  EXPECT_EQ(error("hermite-c2", keys, {.rate = 1.0}),
            "hermite-c2: this method takes rates from the keys, wanted one that has its own");
  const auto one = Keyframes::make({.times = {0}, .orientations = {Eigen::Quaterniond::Identity()}}).value();
  EXPECT_EQ(error("auto", one, {.rate = 1.0}), "found 1 key, wanted 2 at least: one key does not move");
  EXPECT_TRUE(error("nothing", keys, {.rate = 1.0}).starts_with("unknown method 'nothing', wanted one of auto"));
}

TEST(Retime, IsFollowedAndStopped) {
  const Keyframes keys = random_keys(11, {8, 2.0, 20.0});
  const double limit = sampled(make_curve("auto", keys).value()).rate / 3.0;
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval})
    testing_support::expect_to_be_followed_and_stopped([&](const Progress& progress) {
      return retime(keys, "auto", {.limits = {.rate = limit}, .slowing = slowing}, progress);
    });
}

}}  // namespace orispline
