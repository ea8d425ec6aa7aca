// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/retime/rest_to_rest.hpp>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

double duration_of(const Keyframes& keys) { return keys.times().back() - keys.times().front(); }

Retiming fastest(std::string_view method, const Track& keys, const MotionLimits& limits) {
  auto retiming = retime(keys, method_from_text(method).value(), {.limits = limits, .slowing = Slowing::fastest_keys});
  EXPECT_TRUE(retiming) << describe(retiming.error());
  return retiming.value_or(Retiming{});
}

/// The intervals between keys by factors: all by one or, with a seed, each by another one from 1/100 to 100 as well.
Keyframes typed_anew(const Keyframes& keys, double factor, std::optional<unsigned> seed = {}) {
  std::mt19937 generator(seed.value_or(0));
  std::uniform_real_distribution<double> exponents(-2.0, 2.0);
  std::vector<double> times{keys.times().front()};
  for (std::size_t i = 1; i < keys.size(); ++i)
    times.push_back(times.back() + (keys.times()[i] - keys.times()[i - 1]) * factor *
                                       (seed ? std::pow(10.0, exponents(generator)) : 1.0));
  return at_times(keys, std::move(times));
}

TEST(FastestKeys, DoNotDependOnTheTimesThatWereTyped) {
  const Keyframes keys = random_keys(5, {14, 1.8, 10.0});
  const MotionLimits limits{.rate = 1.5, .acceleration = 2.0};
  for (const std::string_view method : {"auto", "timed-c2:ends=rest", "bspline", "rotation-spline"}) {
    const double duration = duration_of(fastest(method, keys, limits).track.keys);
    for (const Keyframes& typed : {typed_anew(keys, 0.02), typed_anew(keys, 50.0), typed_anew(keys, 1.0, 1U)}) {
      const Retiming again = fastest(method, typed, limits);
      EXPECT_NEAR(duration_of(again.track.keys) / duration, 1.0, 1e-9) << method;
      EXPECT_NEAR(again.time_scale * duration_of(typed) / duration, 1.0, 1e-9) << method;
    }
  }
}

TEST(FastestKeys, KeepTheLimitsAndReachOneOfThem) {
  const MotionLimits limits{.rate = 1.0, .acceleration = 2.0, .torque = 3.0, .inertia = inertia};
  unsigned seed = 70;
  for (const std::string_view method : {"auto", "timed-c1", "timed-c3", "bspline"})
    for (const KeyDrawing how : {KeyDrawing{12, 2.9, 100.0}, KeyDrawing{3, 1.0}, KeyDrawing{2, 3.0}}) {
      const Retiming fast = fastest(method, random_keys(++seed, how), limits);
      const MotionSizes peaks = sampled(curve_of(method, fast));
      EXPECT_LE(std::max({peaks.rate, peaks.acceleration / 2.0, peaks.torque / 3.0}), 1.0) << method;
      EXPECT_GE(std::max({peaks.rate, peaks.acceleration / 2.0, peaks.torque / 3.0}), 1.0 - 3e-4) << method;
      EXPECT_EQ(fast.slowing, Slowing::fastest_keys);
      EXPECT_LE(fast.slack, 2e-4) << method;
    }
}

TEST(FastestKeys, AreNoSlowerThanIntervalsThatAreSlowedByThemselves) {
  for (unsigned seed = 80; seed < 90; ++seed)
    for (const std::string_view method : {"auto", "timed-c2", "timed-c3"}) {
      const Keyframes keys = typed_anew(random_keys(seed, {20, 2.0, 4.0}), 0.02);
      const MotionLimits limits{.rate = 1.5, .acceleration = 2.0};
      const double slowed = duration_of(retimed(method, keys, limits, Slowing::per_interval).track.keys);
      EXPECT_LE(duration_of(fastest(method, keys, limits).track.keys), 1.01 * slowed) << method << ", " << seed;
    }
}

TEST(FastestKeys, OfGeodesicsTakeTheAngleOverTheLimit) {
  const Keyframes keys = random_keys(4, {40, 2.5, 30.0});
  double least = 0.0;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    least += increment(keys.orientations()[i], keys.orientations()[i + 1]).norm() / 0.7;
  const double duration = duration_of(fastest("slerp", keys, {.rate = 0.7}).track.keys);
  EXPECT_GE(duration, least);
  EXPECT_LE(duration, least * 1.002);
}

TEST(FastestKeys, KeepTheDurationOfRests) {
  KeyframeData data{.times = {0.0, 5.0, 7.5, 12.0}};
  for (const double angle : {0.0, 1.0, 1.0, 0.3})
    data.orientations.push_back(exp<double>(angle * Eigen::Vector3d::UnitX()));
  const Keyframes keys = Keyframes::make(std::move(data)).value();
  const Retiming fast = fastest("auto:hold=1", keys, {.rate = 1.0, .acceleration = 4.0});
  const auto times = fast.track.keys.times();
  EXPECT_NEAR(times[2] - times[1], 2.5, 1e-14);
  EXPECT_LT(times[1], 4.0);
}

TEST(RestToRest, TakesTheLeastTime) {
  const double turn = std::numbers::pi / 2, rate = turn, acceleration = turn / 0.45, jerk = acceleration / 0.1;
  // A quarter turn within 90°/s, 200°/s² and 2000°/s³ takes 1.55 s, as Ruckig finds.
  EXPECT_NEAR(RestToRest({turn / rate, turn / acceleration, turn / jerk}).duration(), 1.55, 1e-12);
  EXPECT_NEAR(RestToRest({turn / rate, turn / acceleration, 0.0}).duration(), 1.45, 1e-12);
  EXPECT_NEAR(RestToRest({0.0, 1.0, 0.0}).duration(), 2.0, 1e-12);
  EXPECT_NEAR(RestToRest({0.0, 0.0, 1.0}).duration(), std::cbrt(32.0), 1e-12);
  EXPECT_NEAR(RestToRest({3.0, 0.0, 0.0}).duration(), 3.0, 1e-12);
}

TEST(RestToRest, RisesWithinItsLimits) {
  for (const std::array<double, 3>& way :
       {std::array{1.0, 0.45, 0.045}, {1.0, 1.0, 1.0}, {0.1, 0.5, 0.01}, {0.0, 1.0, 0.3}, {1.0, 0.3, 0.0}}) {
    const RestToRest motion(way);
    EXPECT_EQ(motion.time_of(0.0), 0.0);
    EXPECT_EQ(motion.time_of(1.0), motion.duration());
    for (int i = 1; i <= 1000; ++i)
      EXPECT_GE(motion.time_of(1e-3 * i) - motion.time_of(1e-3 * (i - 1)), 1e-3 * way[0] * (1.0 - 1e-9));
  }
}

/// A quarter turn about z in so many steps, between two rests of 0.1 s.
Keyframes quarter_turn(std::size_t steps) {
  KeyframeData data{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (std::size_t i = 0; i <= steps; ++i) {
    data.times.push_back(0.1 + static_cast<double>(i) / static_cast<double>(steps));
    data.orientations.push_back(exp<double>(
        Eigen::Vector3d(0.0, 0.0, 0.5 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps))));
  }
  data.times.push_back(data.times.back() + 0.1);
  data.orientations.push_back(data.orientations.back());
  return Keyframes::make(std::move(data)).value();
}

const MotionLimits slewing{.rate = 90.0 / degrees, .acceleration = 200.0 / degrees, .jerk = 2000.0 / degrees};

// The least is 1.75 s with its rests; one way down from hasty times alone ended at 1.86 and 2.02 s.
TEST(FastestKeys, GetPastTimesAtWhichNoIntervalByItselfGetsShorter) {
  for (const std::size_t steps : {8u, 16u})
    EXPECT_LE(duration_of(fastest("auto:hold=1", quarter_turn(steps), slewing).track.keys), 1.88) << steps;
}

TEST(FastestKeys, AreFasterWithMoreOfThemAndNeverSlower) {
  for (const Keyframes& keys : {quarter_turn(4), random_keys(91, {8, 2.0, 4.0})})
    for (const std::string_view method : {"auto:hold=1", "timed-c2:ends=rest"}) {
      const double before = duration_of(fastest(method, keys, slewing).track.keys);
      const auto more = retime(keys, method_from_text(method).value(),
                               {.limits = slewing, .slowing = Slowing::fastest_keys, .insert_keys = 2});
      ASSERT_TRUE(more) << describe(more.error());
      EXPECT_LE(duration_of(more->track.keys), (method == "auto:hold=1" ? 0.99 : 1.0) * before) << method;
      const MotionSizes peaks = sampled(make_curve(more->method, more->track.keys).value());
      EXPECT_LE(std::max({peaks.rate / (90.0 / degrees), peaks.acceleration / (200.0 / degrees)}), 1.0);
      EXPECT_LE(peaks.jerk / (2000.0 / degrees), 1.0);
      ASSERT_EQ(more->track.keys.size(), keys.size() + more->inserted.size());
      for (std::size_t i = 0, given = 0; i < more->track.keys.size(); ++i) {
        if (std::ranges::binary_search(more->inserted, i)) continue;
        EXPECT_EQ(more->track.keys.orientations()[i].coeffs(), keys.orientations()[given++].coeffs()) << i;
      }
    }
}

TEST(FastestKeys, AreInsertedOnlyWhereTheyDoNotChangeTheCurve) {
  const auto refused = [](std::string_view method, Slowing slowing) {
    const auto retiming = retime(quarter_turn(4), method_from_text(method).value(),
                                 {.limits = slewing, .slowing = slowing, .insert_keys = 2});
    return retiming ? std::string("none") : describe(retiming.error());
  };
  EXPECT_EQ(refused("auto", Slowing::uniform),
            "insert_keys: it makes the fastest keys faster, wanted `fastest_keys` as well");
  EXPECT_EQ(refused("bspline", Slowing::fastest_keys),
            "insert_keys: bspline: its curve does not pass through its keys, so that more of them would change it, "
            "wanted a method that does, such as auto");
}

/// What is said of keys that turn, shift and turn again by a tenth of a radian and of a metre.
std::string refusal(const MotionLimits& limits, const RetimeOptions& others = {}) {
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0}, .positions = {{0, 0, 0}, {0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0}}};
  for (const double angle : {0.0, 0.1, 0.1, 0.2})
    data.orientations.push_back(exp<double>(angle * Eigen::Vector3d::UnitX()));
  RetimeOptions options = others;
  options.limits = limits;
  options.slowing = Slowing::fastest_keys;
  const auto retiming = retime(Keyframes::make(std::move(data)).value(), std::string_view("auto"), options);
  return retiming ? "none" : describe(retiming.error());
}

TEST(FastestKeys, WantLimitsForEveryStep) {
  const std::string wanted =
      "no limit concerns the step from this key to the next, which would take no time; wanted a limit of what changes "
      "there, such as `max_rate` for a turn or `max_speed` for a shift";
  EXPECT_EQ(refusal({.speed = 1.0}), "key 0: " + wanted);
  EXPECT_EQ(refusal({.rate = 1.0}), "key 1: " + wanted);
  EXPECT_EQ(refusal({.rate = 1.0, .speed = 1.0}), "none");
  const std::string no_limit =
      "found no limit, wanted `max_rate`, `max_acceleration`, `max_jerk`, `max_torque`, `max_speed`, "
      "`max_linear_acceleration`, `duration`, `constant_rate` or `constant_speed`";
  EXPECT_EQ(refusal({}), no_limit);
  EXPECT_EQ(refusal({}, {.shorten_rests = 1.0}), no_limit);
  EXPECT_EQ(refusal({.rate = 1.0}, {.duration = 3.0}),
            "duration: it scales all intervals alike, wanted uniform slowing");
  EXPECT_EQ(
      refusal({.rate = 1e30, .speed = 1e30}),
      "key 0: the limits leave 5e-32 s for the step from this key to the next, wanted limits with which times can "
      "tell these keys apart, such as `max_rate` for degrees in seconds");
}

}}  // namespace orispline
