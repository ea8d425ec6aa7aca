// SPDX-License-Identifier: Apache-2.0
// The splines that are smooth in time on any knots: rates at a key, reductions to the papers, ends, reproduction.
#include <gtest/gtest.h>

#include <families/key_steps.hpp>
#include <families/same_curve.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using Parameters = std::map<std::string, std::vector<double>, std::less<>>;

const std::vector<std::string> timed_names{"timed-c1", "timed-c2", "timed-c3", "timed-sextic"};

CurveOptions with(EndRule rule, Parameters parameters = {}) {
  return {.parameters = std::move(parameters), .start = {.rule = rule}, .end = {.rule = rule}};
}

TEST(Timed, C2WithEqualTensionsOnEvenTimesIsTansQuintic) {
  const Keyframes keys = keyframes(random_walk(141, 7, Spacing::even));
  const std::vector<double> alpha{0.5, 0.6, 0.3, 0.45, 0.7, 0.2, 0.5};
  expect_same(make_curve({"timed-c2", with(EndRule::repeat, {{"tension", alpha}, {"tension2", alpha}})}, keys).value(),
              make_curve({"quintic", with(EndRule::repeat, {{"tension", alpha}})}, keys).value());
}

TEST(Timed, C3WithThePapersTensionsOnEvenTimesIsThe6thDegreeSpline) {
  const Keyframes keys = keyframes(random_walk(142, 6, Spacing::even));
  const std::vector<double> beta{0.1, 0.08, 0.05, 0.12, 0.02, 0.09};
  std::vector<double> first, third;
  for (const double b : beta) first.push_back(6 * b), third.push_back(30 - 360 * b);
  const AnyCurve sextic = make_curve({"sextic", with(EndRule::repeat, {{"tension", beta}})}, keys).value();
  const Parameters three{{"tension", first}, {"tension2", {2.5}}, {"tension3", third}};
  expect_same(make_curve({"timed-c3", with(EndRule::repeat, three)}, keys).value(), sextic);
  expect_same(make_curve({"timed-sextic", with(EndRule::repeat, {{"tension", first}})}, keys).value(), sextic);
}

TEST(Timed, C2WithTensionsHalfAndThreeOnEvenTimesIsAQuartic) {
  const Knots even({0.0, 1.0, 2.0, 3.0});
  const families::TimedC2::Basis basis{{PerKey({0.5}), PerKey({3.0})}};
  const auto functions = basis(even.span(1), Jet<double, 5>::variable(1.3));
  for (const auto& function : functions) EXPECT_NEAR(function.c[5], 0.0, tolerance::series);
  EXPECT_NEAR(functions[0].c[4], -0.5, tolerance::series);  // C̃₁ = 1 - C₀ = 1 + u(1-u)³/2
}

TEST(Timed, SexticIsOfDegreeSixOnAnyKnots) {
  const Knots uneven({0.0, 1.0, 1.1, 2.1});
  const families::TimedSextic::Basis basis{PerKey({0.5, 0.4, 0.6, 0.5})};
  for (std::size_t i = 0; i < 3; ++i)
    for (const auto& function : basis(uneven.span(i), Jet<double, 8>::variable(uneven.times()[i] + 0.03))) {
      const double scale = std::pow(uneven.span(i).step(), 7);
      EXPECT_NEAR(function.c[7] * scale, 0.0, tolerance::series);
    }
}

/// φ_m, ψ_m of the key lemma: derivatives in time of the factors of the step before and after a key.
struct KnotJets {
  std::array<double, 3> phi, psi;
};

KnotJets knot_jets(const std::string& name, double before, double after, std::array<double, 3> tau) {
  const double both = before + after;
  KnotJets j{
      {2 * tau[0] * after / (before * both), -2 * tau[1] / (before * both), 2 * tau[2] / (before * before * both)},
      {2 * tau[0] * before / (after * both), 2 * tau[1] / (after * both), 2 * tau[2] / (after * after * both)}};
  if (name == "timed-sextic") {
    j.phi[1] = -5 * (after - 2 * tau[0] * (after - before)) / (before * before * both);
    j.psi[1] = 5 * (before - 2 * tau[0] * (before - after)) / (after * after * both);
    j.phi[2] = -60 * j.phi[0] / (after * after) - 12 * j.phi[1] / after;
    j.psi[2] = -60 * j.psi[0] / (before * before) + 12 * j.psi[1] / before;
  }
  return j;
}

class TimedFamily : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static AnyCurve curve(const Keyframes& keys, const CurveOptions& options = {}) {
    return make_curve({GetParam(), options}, keys).value();
  }
  [[nodiscard]] static int order() { return find_family(GetParam()).value()->continuity_uneven; }
};

TEST_P(TimedFamily, RatesAtAKeyAreTheClosedFormOfTheKeyLemma) {
  const std::array tau{0.4, 1.3, 0.7};
  Parameters parameters;
  for (const Parameter& p : find_family(GetParam()).value()->parameters)
    parameters[std::string(p.name)] = {tau[parameters.size()]};
  const Keyframes keys = keyframes(random_walk(143, 8, Spacing::uneven));
  const AnyCurve c = curve(keys, {.parameters = parameters});
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const auto [phi, psi] = knot_jets(GetParam(), before, after, tau);
    const Eigen::Vector3d a = step(keys, i - 1), b = step(keys, i);
    const Motion m = c.motion(keys.times()[i]);
    EXPECT_TRUE(near(m.angular_velocity, phi[0] * a + psi[0] * b, tolerance::rates));
    if (order() >= 2) {
      EXPECT_TRUE(
          near(m.angular_acceleration, phi[1] * a + psi[1] * b + phi[0] * psi[0] * a.cross(b), tolerance::rates));
    }
    if (order() >= 3) {
      EXPECT_TRUE(near(m.angular_jerk,
                       phi[2] * a + psi[2] * b + (2 * phi[1] * psi[0] + phi[0] * psi[1]) * a.cross(b) +
                           phi[0] * psi[0] * psi[0] * b.cross(b.cross(a)),
                       tolerance::rates));
    }
  }
}

TEST_P(TimedFamily, StaysSmoothForLargeStepsAtSpacingRatiosOfTen) {
  const Keyframes keys = keyframes(random_walk(144, 12, Spacing::uneven, 3.0));
  const AnyCurve c = curve(keys);
  double velocity = 0, acceleration = 0, jerk = 0, largest_velocity = 0, largest_acceleration = 0, largest_jerk = 0;
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const Motion l = c.motion(keys.times()[i], Side::left), r = c.motion(keys.times()[i], Side::right);
    velocity = std::max(velocity, (l.angular_velocity - r.angular_velocity).norm());
    acceleration = std::max(acceleration, (l.angular_acceleration - r.angular_acceleration).norm());
    jerk = std::max(jerk, (l.angular_jerk - r.angular_jerk).norm());
    largest_velocity = std::max(largest_velocity, l.angular_velocity.norm());
    largest_acceleration = std::max(largest_acceleration, l.angular_acceleration.norm());
    largest_jerk = std::max(largest_jerk, l.angular_jerk.norm());
  }
  EXPECT_LE(velocity, tolerance::continuity * largest_velocity);
  if (order() >= 2) {
    EXPECT_LE(acceleration, tolerance::continuity * largest_acceleration);
  }
  if (order() >= 3) {
    EXPECT_LE(jerk, tolerance::continuity * largest_jerk);
  }
}

TEST(Timed, NaturalEndHasNoAngularAcceleration) {
  const Keyframes keys = keyframes(random_walk(145, 5, Spacing::uneven));
  for (const char* name : {"timed-c2", "timed-c3", "timed-sextic"}) {
    const AnyCurve c = make_curve({name, with(EndRule::natural)}, keys).value();
    for (const double t : {keys.times().front(), keys.times().back()})
      EXPECT_TRUE(near(c.motion(t).angular_acceleration, Eigen::Vector3d::Zero(), tolerance::rates)) << name;
  }
}

TEST_P(TimedFamily, ClampedEndsHaveTheGivenRates) {
  const Eigen::Vector3d start(0.3, -0.2, 0.1), end(-0.4, 0.5, 0.25);
  const Keyframes keys = keyframes(random_walk(146, 5, Spacing::uneven));
  const AnyCurve c = curve(keys, {.start = {.rule = EndRule::clamped, .angular_velocity = start},
                                  .end = {.rule = EndRule::clamped, .angular_velocity = end}});
  EXPECT_TRUE(near(c.motion(keys.times().front()).angular_velocity, start, tolerance::rates));
  EXPECT_TRUE(near(c.motion(keys.times().back()).angular_velocity, end, tolerance::rates));
}

TEST_P(TimedFamily, RestingEndsStandStill) {
  const Keyframes keys = keyframes(random_walk(147, 5, Spacing::uneven));
  const AnyCurve c = curve(keys, with(EndRule::rest));
  for (const double t : {keys.times().front(), keys.times().back()})
    EXPECT_TRUE(near(c.motion(t).angular_velocity, Eigen::Vector3d::Zero(), tolerance::rates));
}

TEST_P(TimedFamily, EndsMayDiffer) {
  const Keyframes keys = keyframes(random_walk(148, 5, Spacing::uneven));
  const AnyCurve c = curve(keys, {.start = {.rule = EndRule::rest}, .end = {.rule = EndRule::repeat}});
  const double h = keys.times()[4] - keys.times()[3];
  EXPECT_TRUE(near(c.motion(keys.times().front()).angular_velocity, Eigen::Vector3d::Zero(), tolerance::rates));
  EXPECT_TRUE(near(c.motion(keys.times().back()).angular_velocity, 0.5 * step(keys, 3) / h, tolerance::rates));
}

TEST_P(TimedFamily, UniformAccelerationAboutAFixedAxisIsExactButForTheSextic) {
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  const auto angle = [](double t) { return 0.4 * t + 0.25 * t * t; };
  KeyframeData data{.times = {0.0, 0.5, 0.8, 1.4, 1.6, 2.1}};
  for (const double t : data.times) data.orientations.push_back(exp<double>(angle(t) * axis));
  const AnyCurve c = curve(keyframes(data), with(EndRule::quadratic));
  double off = 0.0;
  for (const double t : sample_times(data.times, 9))
    off = std::max(off, angular_distance(c(t), exp<double>(angle(t) * axis)));
  if (GetParam() == "timed-sextic") {
    EXPECT_GT(off, tolerance::visible_jump);
  } else {
    EXPECT_LE(off, tolerance::series);
  }
}

TEST_P(TimedFamily, ConstantRateNeedsTheFirstTensionOfOneHalf) {
  const Keyframes keys = keyframes(steady_rotation({0.0, 1.0, 1.1, 2.1}, {0.5, 0.2, -0.6}));
  const Motion m = curve(keys, with(EndRule::natural, {{"tension", {0.3}}})).motion(1.0);
  EXPECT_TRUE(near(m.angular_velocity, 0.6 * Eigen::Vector3d(0.5, 0.2, -0.6), tolerance::rates));
}

INSTANTIATE_TEST_SUITE_P(Each, TimedFamily, testing::ValuesIn(timed_names), [](const auto& test) {
  std::string name = test.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}}  // namespace orispline
