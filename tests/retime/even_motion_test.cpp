// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/even_motion.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/retime/even_law.hpp>

#include "retime/retimed_motion.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

TEST(EvenLaw, RisesStaysAndFalls) {
  const EvenLaw law(10.0, 2.0, 1.5);
  EXPECT_DOUBLE_EQ(law.duration(), 6.5);
  EXPECT_TRUE(law.is_reached());
  EXPECT_EQ(law.at(0.0).speed, 0.0);
  EXPECT_DOUBLE_EQ(law.at(0.75).speed, 1.0);
  EXPECT_DOUBLE_EQ(law.at(3.0).speed, 2.0);
  EXPECT_DOUBLE_EQ(law.at(3.25).length, 5.0);
  EXPECT_DOUBLE_EQ(law.at(6.5).length, 10.0);
  for (const double t : {0.2, 1.5, 2.0, 5.5, 6.3}) EXPECT_NEAR(law.time_of(law.at(t).length), t, 1e-12);
}

TEST(EvenLaw, IsSlowerWhereTheEasesMeet) {
  const EvenLaw law(1.0, 2.0, 1.0);
  EXPECT_FALSE(law.is_reached());
  EXPECT_DOUBLE_EQ(law.duration(), 2.0);
  EXPECT_DOUBLE_EQ(law.at(1.0).speed, 1.0);
  EXPECT_DOUBLE_EQ(law.at(1.0).length, 0.5);
}

TEST(EvenMotion, KeepsTheRateAndThePathOfEveryMethod) {
  const Keyframes keys = random_keys(7, {9, 1.5, 6.0});
  for (const std::string_view method : {"auto", "timed-c2", "timed-c1", "global-c2", "squad-timed"}) {
    const auto even = retime(keys, method, {.constant_rate = 0.5, .path_times = PathTimes::typed});
    ASSERT_TRUE(even) << method << ": " << describe(even.error());
    EXPECT_EQ(even->method.name, "auto");
    EXPECT_LE(even->evenness->unevenness, largest_unevenness) << method;
    EXPECT_LE(even->evenness->turn, largest_turn) << method;
    const AnyCurve curve = curve_of("auto", *even);
    EXPECT_LE(sampled(curve).rate, 0.5 * (1.0 + 2.0 * largest_unevenness)) << method;
    const AngleTravelled before(make_curve(method, keys).value()), after(curve);
    EXPECT_NEAR(after.total() / before.total(), 1.0, 1e-3) << method;
    EXPECT_NEAR(curve.domain().end - curve.domain().start, before.total() / 0.5, 1e-9) << method;
  }
}

/// Places on a circle of 0.2 m, typed at these times.
Keyframes circle(std::vector<double> times) {
  KeyframeData data{.times = std::move(times)};
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    const double angle = 0.25 * std::numbers::pi * static_cast<double>(i);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, angle)));
    data.positions.push_back({0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.4});
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(EvenMotion, DoesNotDependOnHowTheTimesWereTyped) {
  const Keyframes even = circle({0, 1, 2, 3, 4, 5, 6, 7}), uneven = circle({0, 0.4, 1.9, 2.2, 4, 4.3, 6, 7});
  for (const RetimeOptions& options : {RetimeOptions{.constant_rate = 0.5}, RetimeOptions{.constant_speed = 0.1}}) {
    const auto found = retime(even, "auto", options), again = retime(uneven, "auto", options);
    ASSERT_TRUE(found && again) << describe(found ? again.error() : found.error());
    const Retiming &a = *found, &b = *again;
    EXPECT_NEAR(a.track.keys.times().back() / b.track.keys.times().back(), 1.0, 1e-9);
    EXPECT_NEAR(*a.evenness->typed_longer, 0.0, 1e-9);
    EXPECT_TRUE(b.warnings.empty());
  }
  RetimeOptions typed{.constant_speed = 0.1, .path_times = PathTimes::typed};
  const Retiming longer = retime(uneven, "auto", typed).value();
  EXPECT_GT(*longer.evenness->typed_longer, 0.2);
  ASSERT_EQ(longer.warnings.size(), 1u);
  EXPECT_EQ(longer.warnings[0].code, "uneven_times");
}

}}  // namespace orispline
