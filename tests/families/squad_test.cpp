// SPDX-License-Identifier: Apache-2.0
// Eberly's spline of squads and its variant for uneven times.
#include <gtest/gtest.h>

#include <families/key_steps.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(SquadFamily, LeavesAnInnerKeyWithTheMeanOfTheNeighbouringSteps) {
  // Equation 22 makes T_n = (log(q_n⁻¹q_{n+1}) - log(q_n⁻¹q_{n-1}))/2; ω = 2 T_n/h.
  const Keyframes keys = keyframes(random_walk(131, 6, Spacing::even));
  const AnyCurve curve = make_curve("squad", keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i)
    EXPECT_TRUE(near(curve.motion(keys.times()[i]).angular_velocity,
                     (step(keys, i, i + 1) - step(keys, i, i - 1)) / (2 * 0.5), tolerance::series));
}

TEST(SquadFamily, IsTheSquadOfEquation22InTheNormalisedParameter) {
  const Keyframes keys = keyframes(random_walk(132, 4, Spacing::uneven, 0.8));
  const AnyCurve curve = make_curve("squad", keys).value();
  const auto q = keys.orientations();
  const auto inner = [&](std::size_t i) {
    return q[i] * exp<double>(-0.25 * (step(keys, i, i + 1) + step(keys, i, i - 1)));
  };
  for (const double u : {0.1, 0.5, 0.8}) {
    const double t = keys.times()[1] + u * (keys.times()[2] - keys.times()[1]);
    EXPECT_TRUE(near(curve(t), squad<double>(q[1], inner(1), inner(2), q[2], u), tolerance::algebra));
  }
}

TEST(SquadFamily, EndKeyRuleStartsWithTheRateOfTheFirstStep) {
  // a_0 = q_0: S'(0) = q_0 log(q_0⁻¹q_1).
  const Keyframes keys = keyframes(random_walk(133, 5, Spacing::even));
  const End key{.rule = EndRule::key};
  const AnyCurve curve = make_curve({"squad", {.start = key, .end = key}}, keys).value();
  EXPECT_TRUE(near(curve.motion(keys.times().front()).angular_velocity, step(keys, 0, 1) / 0.5, tolerance::series));
  EXPECT_TRUE(near(curve.motion(keys.times().back()).angular_velocity, step(keys, 3, 4) / 0.5, tolerance::series));
}

TEST(SquadFamily, PhantomRuleStartsWithHalfTheRateOfTheFirstStep) {
  const Keyframes keys = keyframes(random_walk(134, 5, Spacing::even));
  const End phantom{.rule = EndRule::phantom};
  const AnyCurve curve = make_curve({"squad", {.start = phantom, .end = phantom}}, keys).value();
  EXPECT_TRUE(near(curve.motion(keys.times().front()).angular_velocity, step(keys, 0, 1) / 1.0, tolerance::series));
  EXPECT_TRUE(near(curve.motion(keys.times().back()).angular_velocity, step(keys, 3, 4) / 1.0, tolerance::series));
}

TEST(SquadTimed, PassesAKeyWithTheTangentOfTheParabolaThroughItsNeighbours) {
  const Keyframes keys = keyframes(random_walk(135, 7, Spacing::uneven, 0.6));
  const AnyCurve curve = make_curve("squad-timed", keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Eigen::Vector3d wanted =
        (after / before * -step(keys, i, i - 1) + before / after * step(keys, i, i + 1)) / (before + after);
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(curve.motion(keys.times()[i], side).angular_velocity, wanted, tolerance::rates)) << "key " << i;
  }
}

TEST(SquadTimed, InBoylesVariantPassesAKeyWithTheMeanOfTheRatesOnEitherSide) {
  const Keyframes keys = keyframes(random_walk(138, 7, Spacing::uneven, 0.6));
  const AnyCurve curve = make_curve({"squad-timed", {.choices = {{"variant", "boyle"}}}}, keys).value();
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Eigen::Vector3d wanted = 0.5 * (step(keys, i - 1, i) / before + step(keys, i, i + 1) / after);
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(curve.motion(keys.times()[i], side).angular_velocity, wanted, tolerance::rates)) << "key " << i;
  }
}

TEST(SquadTimed, HasOneCurveInBothVariantsOnEvenTimes) {
  const Keyframes keys = keyframes(random_walk(139, 6, Spacing::even));
  const AnyCurve geier = make_curve({"squad-timed", {.choices = {{"variant", "geier"}}}}, keys).value();
  const AnyCurve boyle = make_curve({"squad-timed", {.choices = {{"variant", "boyle"}}}}, keys).value();
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(boyle.motion(t), geier.motion(t),
                     {tolerance::algebra, tolerance::series, tolerance::series, tolerance::rates}));
}

TEST(SquadTimed, ReflectedEndStartsWithTheRateOfTheFirstStep) {
  const Keyframes keys = keyframes(random_walk(136, 5, Spacing::uneven, 0.6));
  const double first = keys.times()[1] - keys.times()[0], last = keys.times()[4] - keys.times()[3];
  const AnyCurve curve = make_curve("squad-timed", keys).value();
  EXPECT_TRUE(near(curve.motion(keys.times().front()).angular_velocity, step(keys, 0, 1) / first, tolerance::series));
  EXPECT_TRUE(near(curve.motion(keys.times().back()).angular_velocity, step(keys, 3, 4) / last, tolerance::series));
}

TEST(SquadTimed, OnEvenTimesIsSquad) {
  const Keyframes keys = keyframes(random_walk(137, 6, Spacing::even));
  const AnyCurve timed = make_curve("squad-timed", keys).value(), plain = make_curve("squad", keys).value();
  for (const double t : sample_times(keys.times()))
    if (t >= keys.times()[1] && t < keys.times()[4]) {
      EXPECT_TRUE(near(timed.motion(t), plain.motion(t),
                       {tolerance::algebra, tolerance::series, tolerance::series, tolerance::rates}));
    }
}

TEST(SquadTimed, LosesC1WhereAHandleIsLongerThanAFullTurn) {
  // Known limit of the method: the handle of key 1 is 0.4545 (1.5 + 10 · 1.5) rad = 7.5 rad, and squad takes its
  // logarithm.
  KeyframeData data{.times = {0.0, 0.1, 1.1, 1.2}};
  for (const double angle : {0.0, 1.5, 0.0, 1.5})
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  const AnyCurve curve = make_curve("squad-timed", keyframes(data)).value();
  const Motion left = curve.motion(0.1, Side::left), right = curve.motion(0.1, Side::right);
  EXPECT_GT((left.angular_velocity - right.angular_velocity).norm(), 1.0);
}

TEST(SquadTimed, GoesThroughAFullTurnWithContinuousRates) {
  // The signs ask for a full turn to key 1; seen from there it goes back the same way.
  const KeyframeData data{
      .times = {0.0, 1.0, 2.0, 3.0},
      .orientations = {quaternion_wxyz(1.0, 0.0, 0.0, 0.0), quaternion_wxyz(-1.0, 0.0, 0.0, 0.0),
                       quaternion_wxyz(-0.8, 0.0, -0.6, 0.0), quaternion_wxyz(-0.6, 0.0, -0.8, 0.0)}};
  for (const std::string family : {"squad", "squad-timed"}) {
    const AnyCurve curve = make_curve(family, keyframes(data)).value();
    const Motion left = curve.motion(1.0, Side::left), right = curve.motion(1.0, Side::right);
    EXPECT_TRUE(near(left.angular_velocity, right.angular_velocity, tolerance::continuity)) << family;
  }
}

}}  // namespace orispline
