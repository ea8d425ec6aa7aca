// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "retime/retimed_motion.hpp"
#include "support/follower.hpp"
#include "support/random_motion.hpp"

namespace orispline {
namespace {

double angle_between(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q) { return increment(p, q).norm(); }

/// Turns about one axis by angles at even times up to 1 s.
template <class Angle>
Keyframes turning(Angle angle, std::size_t segments) {
  KeyframeData data;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(segments);
    data.times.push_back(u);
    data.orientations.push_back(exp<double>(angle(u) * Eigen::Vector3d(0.6, 0.0, 0.8)));
  }
  return Keyframes::make(std::move(data)).value();
}

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
    for (const RandomKeys how : {RandomKeys{12, 2.9, 100.0}, RandomKeys{3, 1.0}, RandomKeys{2, 3.0}}) {
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

std::string error(std::string_view method, const Keyframes& keys, const MotionLimits& limits) {
  const auto retiming = retime(keys, method, {.limits = limits});
  return retiming ? std::string("none") : describe(retiming.error());
}

TEST(Retime, SaysHowItSlowed) {
  const Keyframes keys = random_keys(4, {40, 2.5, 30.0}), steady = turning([](double u) { return u; }, 4);
  EXPECT_EQ(retimed("slerp", keys, {.rate = 1.0}, Slowing::uniform).slowing, Slowing::uniform);
  EXPECT_EQ(retimed("slerp", keys, {.rate = 1.0}, Slowing::per_interval).slowing, Slowing::per_interval);
  EXPECT_EQ(retimed("slerp", steady, {.rate = 0.1}, Slowing::per_interval).slowing, Slowing::uniform);
}

constexpr double degrees = std::numbers::pi / 180.0;

TEST(Retime, KeepsItsPromiseWhereStepsDifferByAMillionAndMore) {
  const Keyframes five = at_times(random_keys(2, {5, 1.5}), {0.0, 1.0, 1.0 + 1e-6, 2.0, 3.0});
  for (const Keyframes& keys : {five, random_keys(2, {11, 1.5, 1e9})})
    for (const std::string_view method : {"timed-c1", "timed-c2", "timed-c3", "auto"}) {
      const Retiming slow = retimed(method, keys, {.rate = 90.0 * degrees});
      EXPECT_LE(slow.slack, 2e-4) << method;
      EXPECT_TRUE(slow.warnings.empty()) << method;
      const double rate = sampled(curve_of(method, slow)).rate / (90.0 * degrees);
      EXPECT_LE(rate, 1.0) << method;
      EXPECT_GE(rate, 1.0 - 1e-2) << method;
      const Retiming gentle = retimed(method, five, {.acceleration = 200.0 * degrees});
      EXPECT_LE(gentle.slack, 2e-4) << method;
      EXPECT_GE(sampled(curve_of(method, gentle)).acceleration, (1.0 - 1e-2) * 200.0 * degrees) << method;
    }
}

TEST(Retime, RefusesLimitsThatAreNone) {
  const Keyframes keys = random_keys(1, {4, 1.0});
  EXPECT_EQ(error("auto", keys, {}),
            "found no limit, wanted `max_rate`, `max_acceleration`, `max_jerk`, `max_torque`, `max_speed`, "
            "`max_linear_acceleration` or `duration`");
  EXPECT_EQ(error("auto", keys, {.rate = 0.0}), "max_rate: found 0 rad/s, wanted more than 0 rad/s");
  EXPECT_EQ(error("auto", keys, {.acceleration = -2.0}),
            "max_acceleration: found -2 rad/s², wanted more than 0 rad/s²");
  EXPECT_EQ(error("auto", keys, {.rate = std::numeric_limits<double>::infinity()}),
            "max_rate: found inf rad/s, wanted more than 0 rad/s and finite");
  EXPECT_EQ(error("auto", keys, {.rate = std::numeric_limits<double>::quiet_NaN()}),
            "max_rate: found nan rad/s, wanted more than 0 rad/s");
  EXPECT_EQ(error("auto", keys, {.torque = 1.0}), "max_torque: wanted `inertia` as well");
  EXPECT_EQ(error("auto", keys, {.rate = 1.0, .inertia = Eigen::Matrix3d::Identity()}),
            "inertia: wanted `max_torque` as well");
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
  EXPECT_TRUE(error("nothing", keys, {.rate = 1.0}).starts_with("no method 'nothing', wanted one of auto"));
}

/// From rest to rest and on, by 2 rad about one axis each: equal keys for 1 s, then eight segments of 1/8 s.
Keyframes stop_and_go(std::size_t slews) {
  KeyframeData data;
  double t = 0.0, angle = 0.0;
  const auto add = [&](double to) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(to * Eigen::Vector3d(0.6, 0.0, 0.8)));
  };
  add(angle);
  for (std::size_t slew = 0; slew < slews; ++slew) {
    t += 1.0;
    add(angle);
    for (int i = 1; i <= 8; ++i) {
      const double u = i / 8.0;
      t += 0.125;
      add(angle + 2.0 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u)));
    }
    angle += 2.0;
  }
  t += 1.0;
  add(angle);
  return Keyframes::make(data).value();
}

TEST(Retime, KeepsTheDurationOfRests) {
  const Keyframes keys = stop_and_go(3);
  const Method holding = holding_rests("auto", keys);
  EXPECT_EQ(holding.options.parameters.at("hold"), std::vector<double>{1.0});
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const Retiming slow =
        retime(keys, holding, {.limits = {.rate = 1.0, .acceleration = 4.0}, .slowing = slowing}).value();
    EXPECT_EQ(slow.rests, (std::vector<std::size_t>{0, 9, 18, 27}));
    const auto t = slow.track.keys.times();
    for (const std::size_t i : slow.rests) EXPECT_NEAR(t[i + 1] - t[i], 1.0, 1e-12);
    EXPECT_TRUE(slow.warnings.empty()) << describe(slow.warnings.front());
    const AnyCurve curve = make_curve(slow.method, slow.track.keys).value();
    const MotionSizes peaks = sampled(curve);
    EXPECT_LE(peaks.rate, 1.0);
    EXPECT_LE(peaks.acceleration, 4.0);
    EXPECT_GE(std::max(peaks.rate, peaks.acceleration / 4.0), 1.0 - 3e-4);
    for (const std::size_t i : slow.rests)
      EXPECT_LE(curve.motion(0.5 * (t[i] + t[i + 1])).angular_velocity.norm(), 1e-12);
  }
}

TEST(Retime, ShortensRestsOnRequest) {
  const Keyframes keys = stop_and_go(2);
  const Retiming shorter = retime(keys, holding_rests("auto", keys), {.shorten_rests = 0.25}).value();
  EXPECT_NEAR(shorter.time_scale, (2.0 + 3.0 * 0.25) / 5.0, 1e-12);
  const auto t = shorter.track.keys.times();
  for (const std::size_t i : shorter.rests) EXPECT_NEAR(t[i + 1] - t[i], 0.25, 1e-12);
  const Retiming same = retime(keys, holding_rests("auto", keys), {.shorten_rests = 2.0}).value();
  EXPECT_EQ(same.time_scale, 1.0);
  EXPECT_TRUE(std::ranges::equal(same.track.keys.times(), keys.times()));
}

TEST(Retime, WarnsOfMotionInRests) {
  const Keyframes keys = stop_and_go(2);
  const Retiming moving = retimed("timed-c2", keys, {.rate = 1.0});
  ASSERT_EQ(moving.warnings.size(), 1u);
  EXPECT_EQ(moving.warnings[0].code, "moving_rests");
  EXPECT_EQ(moving.warnings[0].number("rests"), 3);
  const auto t = moving.track.keys.times();
  for (const std::size_t i : moving.rests) EXPECT_NEAR(t[i + 1] - t[i], 1.0, 1e-12);
  EXPECT_LE(sampled(curve_of("timed-c2", moving)).rate, 1.0);
}

TEST(Retime, TakesKeysForARestThatAreEqualButForRounding) {
  const auto turned = [](double angle) { return exp<double>(angle * Eigen::Vector3d::UnitX()); };
  const auto rest_of = [&](double angle, double length) {
    return Keyframes::make({.times = {0, 1, 2, 3},
                            .orientations = {turned(0), turned(1), turned(1 + angle), turned(2)},
                            .positions = {{0, 0, 0}, {1, 0, 0}, {1 + length, 0, 0}, {2, 0, 0}}})
        .value()
        .rests_after(1);
  };
  EXPECT_TRUE(rest_of(0.0, 0.0));
  EXPECT_TRUE(rest_of(2e-6, 0.0));
  EXPECT_TRUE(rest_of(0.999e-5, 0.999e-6));
  EXPECT_FALSE(rest_of(1.001e-5, 0.0));
  EXPECT_FALSE(rest_of(0.0, 1.001e-6));
  EXPECT_FALSE(rest_of(0.0, 1.0));
}

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

TEST(Retime, MeetsADuration) {
  const Keyframes keys = stop_and_go(2);
  const Method holding = holding_rests("auto", keys);
  for (const double duration : {4.0, 5.0, 20.0}) {
    const Retiming lasting = retime(keys, holding, {.duration = duration}).value();
    EXPECT_EQ(lasting.track.keys.times().back(), duration);
    EXPECT_NEAR(lasting.time_scale, duration / 5.0, 1e-15);
    for (const std::size_t i : lasting.rests)
      EXPECT_NEAR(lasting.track.keys.times()[i + 1] - lasting.track.keys.times()[i], 1.0, 1e-12);
  }
  const auto refused = [&](const RetimeOptions& options) { return describe(retime(keys, holding, options).error()); };
  EXPECT_EQ(refused({.duration = 2.5}),
            "duration: found 2.5 s, and the rests alone take 3 s of 5 s; wanted more, or `shorten_rests` as well");
  EXPECT_TRUE(refused({.limits = {.rate = 1.0}, .duration = 5.0})
                  .starts_with("duration: in 5 s the motion exceeds its limits, wanted some 10.5"));
  EXPECT_TRUE(retime(keys, holding, {.limits = {.rate = 1.0}, .duration = 12.0}));
  EXPECT_EQ(refused({.slowing = Slowing::per_interval, .duration = 5.0}),
            "duration: all intervals are scaled alike for it, wanted no slowing of each by itself");
}

TEST(Retime, IsFollowedAndStopped) {
  const Keyframes keys = random_keys(11, {8, 2.0, 20.0});
  const double limit = sampled(make_curve("auto", keys).value()).rate / 3.0;
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval})
    testing_support::expect_to_be_followed_and_stopped([&](const Progress& progress) {
      return retime(keys, "auto", {.limits = {.rate = limit}, .slowing = slowing}, progress);
    });
}

}  // namespace
}  // namespace orispline
