// SPDX-License-Identifier: Apache-2.0
// The 6th-degree spline: Lemmas 1, 3 and 4 as corrected, degrees, knots, the repeated end.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/pure_quaternion.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::Sextic;
using Jet6 = Jet<double, 6>;

const std::vector<double> sextic_tensions{0.109, 0.093, 0.055, 0.081, 0.112, 0.078};

AnyCurve sextic(const Keyframes& keys) {
  return make_curve({"sextic", {.parameters = {{"tension", sextic_tensions}}}}, keys).value();
}

/// The three blending functions of segment 0 over unit knots, as jets at u.
std::array<Jet6, 3> sextic_blending(double left, double right, double u) {
  const Knots unit({0.0, 1.0});
  return Sextic::Basis{PerKey({left, right})}(unit.span(0), Jet6::variable(u));
}

TEST(Sextic, BlendingFunctionsHaveTheEndValuesOfLemma1) {
  const double a = 0.07, b = 0.11;
  const auto start = sextic_blending(a, b, 0.0), end = sextic_blending(a, b, 1.0);
  const auto expect = [](const Jet6& found, std::array<double, 4> wanted) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found.derivative(k), wanted[k], tolerance::series) << "order " << k;
  };
  expect(start[0], {1, 6 * a, -2.5, 30 - 360 * a});
  expect(start[1], {0, 6 * a, 2.5, 30 - 360 * a});
  expect(start[2], {0, 0, 0, 0});
  expect(end[0], {1, 0, 0, 0});
  expect(end[1], {1, 6 * b, -2.5, 30 - 360 * b});
  expect(end[2], {0, 6 * b, 2.5, 30 - 360 * b});
}

TEST(Sextic, BlendingFunctionsHaveTheLeadingCoefficientsOfDegreeSix) {
  const double a = 0.07, b = 0.11;
  const auto c = sextic_blending(a, b, 0.4);
  EXPECT_NEAR(c[0].c[6], 24 * a - 1.25, tolerance::series);
  EXPECT_NEAR(c[1].c[6], 24 * (a - b), tolerance::series);
  EXPECT_NEAR(c[2].c[6], 1.25 - 24 * b, tolerance::series);
}

TEST(Sextic, AtBeta5Over96IsTheQuinticOf2018) {
  // C_0 = -(5/16) u (1-u)⁴, so C̃_1 = 1 - C_0.
  const double beta = 5.0 / 96.0, u = 0.3, v = 1.0 - u;
  const auto c = sextic_blending(beta, beta, u);
  for (const Jet6& function : c) EXPECT_NEAR(function.c[6], 0.0, tolerance::series);
  EXPECT_GT(std::abs(c[0].c[5]), 0.1);
  EXPECT_NEAR(c[0].c[0], 1.0 + 5.0 / 16.0 * u * v * v * v * v, tolerance::algebra);
  EXPECT_NEAR(c[2].c[0], -5.0 / 16.0 * u * u * u * u * v, tolerance::algebra);
}

TEST(Sextic, EndDerivativesAreLemmas3And4Corrected) {
  const Keyframes keys = keyframes(random_walk(111, 6, Spacing::even));
  const double h = 0.5;
  const auto curve = typed_curve<Sextic>(keys, {.parameters = {{"tension", sextic_tensions}}});
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const AnyQuaternion q = keys.orientations()[i];
    const AnyQuaternion a = half_log(keys.orientations()[i - 1], keys.orientations()[i]);
    const AnyQuaternion b = half_log(keys.orientations()[i], keys.orientations()[i + 1]);
    const double s = 6.0 * sextic_tensions[i];
    const AnyQuaternion first = s * (q * (a + b));
    const AnyQuaternion second = q * (s * s * (a * a + 2.0 * (a * b) + b * b) + 2.5 * (b - a));
    const AnyQuaternion third =
        q * (s * s * s * (a * a * a + 3.0 * (a * a * b) + 3.0 * (a * b * b) + b * b * b) +
             45.0 * sextic_tensions[i] * (b * b - a * a) + (30.0 - 360.0 * sextic_tensions[i]) * (a + b));
    for (const std::size_t segment : {i - 1, i}) {
      const auto found = quaternion_derivatives(curve, keys.times()[i], segment);
      EXPECT_TRUE(near(h * found[1], first.coeffs(), tolerance::series)) << "key " << i;
      EXPECT_TRUE(near(h * h * found[2], second.coeffs(), tolerance::series)) << "key " << i;
      EXPECT_TRUE(near(h * h * h * found[3], third.coeffs(), tolerance::series)) << "key " << i;
    }
  }
}

TEST(Sextic, RatesJumpByPowersOfTheRatioOfTheStepsAtUnevenKnots) {
  const Keyframes keys = keyframes(random_walk(112, 6, Spacing::uneven));
  const AnyCurve curve = sextic(keys);
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Motion left = curve.motion(keys.times()[i], Side::left), right = curve.motion(keys.times()[i], Side::right);
    EXPECT_TRUE(near(right.angular_velocity * after, left.angular_velocity * before, tolerance::series));
    EXPECT_TRUE(near(right.angular_acceleration * std::pow(after, 2), left.angular_acceleration * std::pow(before, 2),
                     tolerance::series));
    EXPECT_TRUE(
        near(right.angular_jerk * std::pow(after, 3), left.angular_jerk * std::pow(before, 3), tolerance::series));
  }
}

TEST(Sextic, ZeroTensionStopsTheMotionButKeepsItsAcceleration) {
  std::vector<double> stop = sextic_tensions;
  stop[2] = 0.0;
  const Keyframes keys = keyframes(random_walk(113, 6, Spacing::even));
  const Motion m = make_curve({"sextic", {.parameters = {{"tension", stop}}}}, keys)->motion(keys.times()[2]);
  const Eigen::Vector3d a = increment<double>(keys.orientations()[1], keys.orientations()[2]);
  const Eigen::Vector3d b = increment<double>(keys.orientations()[2], keys.orientations()[3]);
  EXPECT_TRUE(near(m.angular_velocity, Eigen::Vector3d::Zero(), tolerance::algebra));
  EXPECT_TRUE(near(m.angular_acceleration, 2.5 * (b - a) / 0.25, tolerance::series));
}

TEST(Sextic, RepeatedEndKeyHasTheStatedRates) {
  const Keyframes keys = keyframes(random_walk(114, 6, Spacing::even));
  const Eigen::Vector3d b = increment<double>(keys.orientations()[0], keys.orientations()[1]);
  const Motion m = sextic(keys).motion(keys.times().front());
  const double h = 0.5;
  EXPECT_TRUE(near(m.angular_velocity, 6 * sextic_tensions[0] * b / h, tolerance::series));
  EXPECT_TRUE(near(m.angular_acceleration, 2.5 * b / (h * h), tolerance::series));
  EXPECT_TRUE(near(m.angular_jerk, (30 - 360 * sextic_tensions[0]) * b / (h * h * h), tolerance::series));
}

}}  // namespace orispline
