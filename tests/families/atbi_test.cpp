// SPDX-License-Identifier: Apache-2.0
// The algebraic-trigonometric basis against what defines it: its span, its values and derivatives at the ends.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using Jet5 = Jet<double, 5>;

/// The four blending functions C_0 … C_3 as jets at u, from the cumulative ones.
std::array<Jet5, 4> atbi_blending(double u) {
  const Knots unit({0.0, 1.0});
  const auto sums = families::Atbi::Basis{}(unit.span(0), Jet5::variable(u));
  return {Jet5(1.0) - sums[0], sums[0] - sums[1], sums[1] - sums[2], sums[2]};
}

TEST(Atbi, BlendsWithinTheSpanOfOneUUSquaredSineAndCosine) {
  // Exactly these functions satisfy f⁗' + π² f''' = 0.
  for (const double u : {0.0, 0.15, 0.4, 0.8, 1.0})
    for (const Jet5& c : atbi_blending(u))
      EXPECT_NEAR(c.derivative(5) + pi * pi * c.derivative(3), 0.0, 1e3 * tolerance::algebra) << u;
}

TEST(Atbi, MeetsTheKeysWithTheCentralDifferenceAndQuarterPiSquaredTimesTheSecondDifference) {
  // Segment of keys 1 and 2: p = P_k, p' = (P_{k+1} - P_{k-1})/2, p'' = π²/4 (P_{k+1} - 2 P_k + P_{k-1}).
  const double bend = pi * pi / 4.0;
  const std::array<std::array<double, 4>, 3> start{{{0, 1, 0, 0}, {-0.5, 0, 0.5, 0}, {bend, -2 * bend, bend, 0}}};
  const std::array<std::array<double, 4>, 3> end{{{0, 0, 1, 0}, {0, -0.5, 0, 0.5}, {0, bend, -2 * bend, bend}}};
  const auto at_start = atbi_blending(0.0), at_end = atbi_blending(1.0);
  for (std::size_t order = 0; order < 3; ++order)
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(at_start[k].derivative(order), start[order][k], tolerance::algebra) << "C_" << k;
      EXPECT_NEAR(at_end[k].derivative(order), end[order][k], tolerance::algebra) << "C_" << k;
    }
}

TEST(Atbi, SumsToOneAndReproducesEvenSteps) {
  for (const double u : {0.0, 0.2, 0.5, 0.9}) {
    const auto c = atbi_blending(u);
    EXPECT_NEAR(c[0].c[0] + c[1].c[0] + c[2].c[0] + c[3].c[0], 1.0, tolerance::algebra);
    EXPECT_NEAR(-c[0].c[0] + c[2].c[0] + 2.0 * c[3].c[0], u, tolerance::algebra);
  }
}

TEST(Atbi, IsTheFormulaOfItsPage) {
  for (const double u : {0.1, 0.37, 0.5, 0.83}) {
    const double sine = std::sin(pi * u), cosine = std::cos(pi * u), linear = 0.25 + pi * pi / 16.0;
    const double outer =
        0.125 - linear * u + pi * pi / 16.0 * u * u - (2.0 - pi * pi / 2.0) / (8.0 * pi) * sine - 0.125 * cosine;
    const double inner = 0.375 + linear * u - pi * pi / 16.0 * u * u + (0.5 - linear) / pi * sine - 0.375 * cosine;
    EXPECT_NEAR(atbi_blending(u)[0].c[0], outer, tolerance::algebra);
    EXPECT_NEAR(atbi_blending(1.0 - u)[3].c[0], outer, tolerance::algebra);
    EXPECT_NEAR(atbi_blending(u)[2].c[0], inner, tolerance::algebra);
    EXPECT_NEAR(atbi_blending(1.0 - u)[1].c[0], inner, tolerance::algebra);
  }
}

TEST(Atbi, AboutOneAxisHasTheRatesOfItsBasisAtAKey) {
  KeyframeData data{.times = {0.0, 0.5, 1.0, 1.5, 2.0}};
  const std::array angles{0.0, 0.4, 0.1, 0.9, 0.7};
  for (const double angle : angles) data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  const AnyCurve c = make_curve("atbi", keyframes(data)).value();
  for (std::size_t i = 1; i < 4; ++i)
    for (const Side side : {Side::left, Side::right}) {
      const Motion m = c.motion(data.times[i], side);
      EXPECT_NEAR(m.angular_velocity.z(), angles[i + 1] - angles[i - 1], tolerance::series);
      EXPECT_NEAR(m.angular_acceleration.z(), pi * pi * (angles[i + 1] - 2.0 * angles[i] + angles[i - 1]),
                  tolerance::series);
    }
}

}}  // namespace orispline
