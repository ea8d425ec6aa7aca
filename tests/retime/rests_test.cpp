// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/limited_motion.hpp>
#include <orispline/retime/retime.hpp>

#include <gtest/gtest.h>
#include <vector>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

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

/// The greatest factor that a bound asks for still.
double factor_of_bounds(const Retiming& retiming, const MotionLimits& limits) {
  double factor = 0.0;
  for (const SegmentPeaks& peaks : retiming.peaks) {
    QuantitySizes bounds{};
    std::ranges::transform(peaks, bounds.begin(), &CertifiedPeak::bound);
    factor = std::max(factor, needed_factor(bounds, quantities_of(limits)));
  }
  return factor;
}

// Beside rests that keep their duration, the motion is another one at every factor, and its peaks go with no power of
// it.
TEST(Retime, SlowsNoMoreThanNeededABodyThatMovesInRests) {
  const Eigen::Quaterniond there(0.5, 0.5, 0.5, 0.5), by_a_full_turn(-0.5, -0.5, -0.5, -0.5);
  const Keyframes full_turn = Keyframes::make({.times = {0.0, 1.0, 2.0, 3.0, 4.0},
                                               .orientations = {there, there, there, by_a_full_turn, by_a_full_turn}},
                                              Signs::as_given)
                                  .value();
  for (const double size : {0.1, 0.3, 1.0, 3.0})
    for (const MotionLimits& limits :
         {MotionLimits{.rate = size}, MotionLimits{.acceleration = size}, MotionLimits{.jerk = size}})
      for (const std::string_view method : {"auto", "timed-c2", "timed-c3"}) {
        const Retiming slow = retimed(method, full_turn, limits);
        if (slow.time_scale == 1.0) continue;
        EXPECT_LE(factor_of_bounds(slow, limits), 1.0) << method << " " << size;
        EXPECT_GE(factor_of_bounds(slow, limits), 1.0 - 1e-4) << method << " " << size;
        EXPECT_LE(slow.slack, 2e-4) << method << " " << size;
      }
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
            "duration: it scales all intervals alike, wanted uniform slowing");
}

}}  // namespace orispline
