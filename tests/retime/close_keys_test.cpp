// SPDX-License-Identifier: Apache-2.0
// Keys so close together that the rounding of their times or of themselves shows.
#include <cmath>
#include <functional>
#include <random>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

// Keys a few roundings of time apart: no attempt at less slowing makes two of them one.
TEST(Retime, KeepsKeysApartThatAreNextToEachOtherInTime) {
  constexpr double ulp = 1.0 / 4194304.0;  // of 1.7e9 [s]
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Keyframes keys = random_keys(seed, {6, 0.02, 2.0});
    std::vector<double> times{1.7e9};
    std::mt19937 random(seed);
    for (std::size_t i = 1; i < keys.size(); ++i)
      times.push_back(times.back() + ulp * static_cast<double>(1 + random() % 3));
    for (const double rate : {1e3, 1e4, 3e4}) {
      const Retiming slow = retimed("timed-c2", at_times(keys, times), {.rate = rate});
      EXPECT_TRUE(std::ranges::adjacent_find(slow.track.keys.times(), std::greater_equal()) ==
                  slow.track.keys.times().end())
          << seed << " " << rate;
      EXPECT_LE(sampled(curve_of("timed-c2", slow)).rate, rate * (1.0 + 1e-9)) << seed;
    }
  }
}

// A step of 64 roundings of time: bounds of the fast motion are loose there, those of the slowed one are not.
TEST(Retime, SlowsNoMoreAtTheTimesOfTodayHoweverFastTheMotionWas) {
  constexpr double step = 1.0 / 65536.0;  // [s]
  const Keyframes keys = random_keys(29, {8, 2.0, 2.0});
  std::vector<double> early, late;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    early.push_back(step * static_cast<double>(i));
    late.push_back(1.7e9 + early.back());
  }
  for (const MotionLimits& limits : {MotionLimits{.rate = 1.0}, MotionLimits{.acceleration = 2.0}}) {
    const Retiming a = retimed("timed-c2", at_times(keys, early), limits);
    const Retiming b = retimed("timed-c2", at_times(keys, late), limits);
    EXPECT_NEAR(b.time_scale / a.time_scale, 1.0, 2e-4);
    for (const Retiming& slow : {a, b}) {
      EXPECT_LE(slow.slack, 2e-4);
      const MotionSizes met = sampled(curve_of("timed-c2", slow));
      const double used = limits.rate ? met.rate : std::sqrt(met.acceleration / 2.0);
      EXPECT_LE(used, 1.0);
      EXPECT_GE(used, 1.0 - slow.slack - 1e-5);
    }
  }
}

/// Five keys, the two in the middle so far apart in time [s].
Keyframes uneven_keys(double step) {
  const std::vector<Eigen::Vector3d> turns{{0.5, 0.2, -0.9}, {-0.7, 1.1, 0.3}, {0.9, -0.4, 0.8}, {-0.3, -1.2, 0.6}};
  KeyframeData data{.times = {0.0, 1.0, 1.0 + step, 2.0, 3.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (const Eigen::Vector3d& turn : turns) data.orientations.push_back(data.orientations.back() * exp<double>(turn));
  return Keyframes::make(std::move(data)).value();
}

// A body that whirls about turns more often than parts of a segment can follow.
TEST(Retime, SlowsNoMoreThanNeededHoweverFastTheBodyWhirls) {
  for (const std::string_view method : {"auto", "timed-c2", "timed-c3"})
    for (const double step : {1e-3, 1e-5, 1e-7}) {
      const Retiming slow = retimed(method, uneven_keys(step), {.jerk = 10.0});
      EXPECT_LE(slow.slack, 1e-4) << method << step;
      EXPECT_LE(sampled(curve_of(method, slow)).jerk, 10.0) << method << step;
      const Retiming weak = retimed(method, uneven_keys(step), {.torque = 2.0, .inertia = inertia});
      EXPECT_LE(weak.slack, method == "auto" ? 0.05 : 1e-4) << method << step;
      EXPECT_LE(sampled(curve_of(method, weak)).torque, 2.0) << method << step;
    }
}

// A step of 1 ms makes it whirl through the next one, of 18 hours, about the same axis.
TEST(Retime, SlowsNoMoreThanNeededWhereTheBodyWhirlsAboutOneAxis) {
  const Eigen::Quaterniond first(0.5, 0.5, 0.5, 0.5), second = first * exp<double>(Eigen::Vector3d(0.7, -0.2, 0.1));
  const Keyframes keys = Keyframes::make({.times = {0.0, 0.001, 65536.0, 1114112.0, 1114112.001},
                                          .orientations = {first, second, first, first, first}})
                             .value();
  for (const std::string_view method : {"auto", "timed-c2", "timed-c3", "timed-sextic"}) {
    EXPECT_LE(retimed(method, keys, {.jerk = 8.0}).slack, 1e-4) << method;
    EXPECT_LE(retimed(method, keys, {.torque = 1.0, .inertia = inertia}).slack, 1e-4) << method;
  }
}

/// Keys that are equal up to sign and to `rounding`.
Keyframes nearly_equal_keys(unsigned seed, const std::vector<double>& times, double rounding) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> symmetric(-1.0, 1.0);
  KeyframeData data{.times = times};
  for (std::size_t i = 0; i < times.size(); ++i) {
    Eigen::Vector4d q(0.1, -0.7, 0.5, 0.5);
    for (double& component : q) component += rounding * symmetric(generator);
    data.orientations.emplace_back(Eigen::Vector4d(i % 2 == 0 ? q : Eigen::Vector4d(-q)));
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(Retime, KeepsLimitsWhateverTheRoundingOfKeysMakesOfShortSteps) {
  const std::vector<double> times{0.0, 1e-9, 2e-9, 3e-9, 4e-9, 5e-9};
  for (const std::string_view method : {"auto", "timed-c2", "timed-c1", "bspline"})
    for (unsigned seed = 0; seed < 3; ++seed) {
      const Retiming slow = retimed(method, nearly_equal_keys(seed, times, 1e-16), {.acceleration = 0.54});
      const auto later = slow.track.keys.times();
      for (unsigned other = 10; other < 13; ++other) {
        const Keyframes same = nearly_equal_keys(other, {later.begin(), later.end()}, 1e-16);
        EXPECT_LE(sampled(make_curve(method, same).value()).acceleration, 0.54) << method;
      }
    }
}

TEST(Retime, StatesTheSlackThatItsBoundsLeave) {
  const Retiming loose = retimed("auto", nearly_equal_keys(1, {0.0, 1e-9, 2e-9, 3e-9}, 1e-16), {.acceleration = 0.54});
  ASSERT_EQ(loose.warnings.size(), 2u);
  EXPECT_EQ(loose.warnings[1].code, "longer_rests");
  EXPECT_EQ(loose.warnings.front().code, "loose_bounds");
  EXPECT_EQ(loose.warnings.front().number("slack"), loose.slack);
  double found = 0.0;
  for (const SegmentPeaks& peaks : loose.peaks) found = std::max(found, peaks[0].found);
  EXPECT_NEAR(loose.slack, 1.0 - std::sqrt(found / 0.54), 1e-6);
  EXPECT_GT(loose.slack, 0.1);
  const Keyframes keys = random_keys(4, {40, 2.5, 30.0});
  EXPECT_EQ(retimed("auto", keys, {.rate = 1e6}).slack, 0.0);
  for (const Slowing slowing : {Slowing::uniform, Slowing::per_interval}) {
    const Retiming tight = retimed("auto", keys, {.rate = 1.0, .acceleration = 2.0}, slowing);
    EXPECT_GT(tight.slack, 0.0);
    EXPECT_LE(tight.slack, 2e-4);
    EXPECT_FALSE(is_warned_of(tight, "loose_bounds"));
  }
}

}}  // namespace orispline
