// SPDX-License-Identifier: Apache-2.0
// The two Xing splines as derived: degrees, blending functions, what they are members of.
#include <gtest/gtest.h>

#include <families/same_curve.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::XingQuartic;
using families::XingQuintic;
using Jet6 = Jet<double, 6>;

/// The three blending functions as jets at u.
template <class F>
std::array<Jet6, 3> blending(double u) {
  const Knots unit({0.0, 1.0});
  return typename F::Basis{}(unit.span(0), Jet6::variable(u));
}

TEST(XingQuartic, HasBlendingFunctionsOfDegreeFour) {
  const auto c = blending<XingQuartic>(0.3);
  for (const Jet6& function : c)
    for (const std::size_t order : {5u, 6u}) EXPECT_NEAR(function.c[order], 0.0, tolerance::series);
  EXPECT_NEAR(c[0].c[4], -0.5, tolerance::series);
  EXPECT_NEAR(c[2].c[4], 0.5, tolerance::series);
}

TEST(XingQuartic, BlendsTheOuterKeysByHalfUTimesTheCubeOfTheRest) {
  for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double v = 1.0 - u;
    const auto c = blending<XingQuartic>(u);
    EXPECT_NEAR(c[0].c[0], 1.0 + 0.5 * u * v * v * v, tolerance::algebra);  // C̃_1 = 1 - C_0
    EXPECT_NEAR(c[2].c[0], -0.5 * u * u * u * v, tolerance::algebra);       // C̃_3 = C_3
    EXPECT_NEAR(c[1].c[0] + blending<XingQuartic>(v)[1].c[0], 1.0, tolerance::algebra);
  }
}

TEST(XingQuartic, IsTheFamilyOfOrderTwoWithTensionsHalfAndThree) {
  const Keyframes keys = keyframes(random_walk(301, 7, Spacing::uneven));
  expect_same(
      make_curve("xing-quartic", keys).value(),
      make_curve({"uniform", {.parameters = {{"order", {2}}, {"tension1", {0.5}}, {"tension2", {3}}}}}, keys).value());
}

TEST(XingQuartic, CountsTheSecondDifferenceThreefoldAtAKey) {
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.0, 4.0}};
  const std::array angles{0.0, 0.4, 0.1, 0.9, 0.7};
  for (const double angle : angles) data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  const AnyCurve c = make_curve("xing-quartic", keyframes(data)).value();
  for (std::size_t i = 1; i < 4; ++i) {
    const Motion m = c.motion(data.times[i]);
    EXPECT_NEAR(m.angular_velocity.z(), 0.5 * (angles[i + 1] - angles[i - 1]), tolerance::algebra);
    EXPECT_NEAR(m.angular_acceleration.z(), 3.0 * (angles[i + 1] - 2.0 * angles[i] + angles[i - 1]), tolerance::series);
  }
}

TEST(XingQuintic, HasBlendingFunctionsOfDegreeFive) {
  const auto c = blending<XingQuintic>(0.3);
  for (const Jet6& function : c) {
    EXPECT_NEAR(function.c[6], 0.0, tolerance::series);
    EXPECT_GT(std::abs(function.c[5]), 0.1);
  }
}

TEST(XingQuintic, BlendsTheOuterKeysByFiveSixteenths) {
  for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double v = 1.0 - u;
    const auto c = blending<XingQuintic>(u);
    EXPECT_NEAR(c[0].c[0], 1.0 + 5.0 / 16.0 * u * v * v * v * v, tolerance::algebra);
    EXPECT_NEAR(c[2].c[0], -5.0 / 16.0 * u * u * u * u * v, tolerance::algebra);
  }
}

TEST(XingQuintic, IsThe6thDegreeSplineAtBeta5Over96) {
  const Keyframes keys = keyframes(random_walk(302, 7, Spacing::uneven));
  expect_same(make_curve("xing-quintic", keys).value(),
              make_curve({"sextic", {.parameters = {{"tension", {5.0 / 96.0}}}}}, keys).value());
}

TEST(XingQuintic, RipplesOnASteadyRotation) {
  // At a key ω = 6β (a + b)/h = (5/16)·2 of the steady rate; inside it makes up for that.
  const Eigen::Vector3d rate(0.5, -0.3, 0.2);
  const AnyCurve c = make_curve("xing-quintic", keyframes(steady_rotation({0, 1, 2, 3, 4}, rate))).value();
  EXPECT_TRUE(near(c.motion(2.0).angular_velocity, 0.625 * rate, tolerance::algebra));
  EXPECT_GT(c.motion(1.5).angular_velocity.norm(), rate.norm());
}

}}  // namespace orispline
