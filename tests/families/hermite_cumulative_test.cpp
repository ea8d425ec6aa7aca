// SPDX-License-Identifier: Apache-2.0
// Kim's cubic Hermite curve: rates given or estimated, scaled by the tension, reproduced at the keys.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

Keyframes keys_with_rates(std::uint64_t seed) {
  KeyframeData data = random_walk(seed, 6, Spacing::uneven);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < 6; ++i) data.angular_velocities.push_back(2.0 * dice.vector());
  return keyframes(data);
}

AnyCurve hermite(const Keyframes& keys, const CurveOptions& options = {}) {
  return make_curve({"hermite-cumulative", options}, keys).value();
}

Eigen::Vector3d secant(const Keyframes& keys, std::size_t i) {
  return increment<double>(keys.orientations()[i], keys.orientations()[i + 1]) /
         (keys.times()[i + 1] - keys.times()[i]);
}

void expect_rates_from_both_sides(const AnyCurve& c, double t, const Eigen::Vector3d& rate) {
  for (const Side side : {Side::left, Side::right})
    EXPECT_TRUE(near(c.motion(t, side).angular_velocity, rate, tolerance::series)) << t;
}

TEST(HermiteCumulative, HasTheGivenRatesAtTheKeys) {
  const Keyframes keys = keys_with_rates(331);
  const AnyCurve c = hermite(keys);
  for (std::size_t i = 0; i < keys.size(); ++i)
    expect_rates_from_both_sides(c, keys.times()[i], keys.angular_velocities()[i]);
}

TEST(HermiteCumulative, ScalesTheGivenRatesByTheTension) {
  const Keyframes keys = keys_with_rates(332);
  const std::vector<double> tension{1.0, 0.5, 0.0, -0.7, 2.0, 1.3};
  const AnyCurve c = hermite(keys, {.parameters = {{"tension", tension}}});
  for (std::size_t i = 0; i < keys.size(); ++i)
    expect_rates_from_both_sides(c, keys.times()[i], tension[i] * keys.angular_velocities()[i]);
}

TEST(HermiteCumulative, EstimatesTheRateOfTheParabolaThroughThreeKeys) {
  const Keyframes keys = keyframes(random_walk(333, 6, Spacing::uneven));
  const AnyCurve c = hermite(keys), half = hermite(keys, {.parameters = {{"tension", {0.5}}}});
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Eigen::Vector3d rate = (after * secant(keys, i - 1) + before * secant(keys, i)) / (before + after);
    expect_rates_from_both_sides(c, keys.times()[i], rate);
    expect_rates_from_both_sides(half, keys.times()[i], 0.5 * rate);
  }
}

TEST(HermiteCumulative, LeavesAndArrivesWithTheSecantRates) {
  const Keyframes keys = keyframes(random_walk(334, 6, Spacing::uneven));
  const AnyCurve c = hermite(keys);
  EXPECT_TRUE(near(c.motion(keys.times().front()).angular_velocity, secant(keys, 0), tolerance::series));
  EXPECT_TRUE(near(c.motion(keys.times().back()).angular_velocity, secant(keys, 4), tolerance::series));
}

TEST(HermiteCumulative, IsLocalWithGivenRates) {
  KeyframeData data = random_walk(335, 6, Spacing::even);
  data.angular_velocities.assign(6, Eigen::Vector3d(0.4, 0.1, -0.2));
  const AnyCurve before = hermite(keyframes(data));
  data.orientations[5] = data.orientations[5] * exp<double>(Eigen::Vector3d(0.5, 0, 0));
  const AnyCurve after = hermite(keyframes(data));
  EXPECT_EQ(before(data.times[0] + 1.9).coeffs(), after(data.times[0] + 1.9).coeffs());
  EXPECT_NE(before(data.times[0] + 2.1).coeffs(), after(data.times[0] + 2.1).coeffs());
}

TEST(HermiteCumulative, ReproducesASteadyRotationFromItsRate) {
  const Eigen::Vector3d rate(0.5, -0.3, 0.8);
  KeyframeData data = steady_rotation({0.0, 1.0, 1.1, 2.1, 4.0}, rate);
  data.angular_velocities.assign(5, rate);
  const AnyCurve c = hermite(keyframes(data));
  for (const double t : sample_times(data.times, 7)) {
    EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << t;
    EXPECT_TRUE(near(c.motion(t).angular_acceleration, Eigen::Vector3d::Zero(), tolerance::rates)) << t;
  }
}

TEST(HermiteCumulative, OfTwoKeysIsTheGreatArcAtConstantRate) {
  const Keyframes keys = keyframes(random_walk(336, 2, Spacing::even));
  const AnyCurve c = hermite(keys);
  for (const double t : sample_times(keys.times(), 8))
    EXPECT_TRUE(near(c.motion(t).angular_velocity, secant(keys, 0), tolerance::series)) << t;
}

}}  // namespace orispline
