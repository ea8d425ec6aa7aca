// SPDX-License-Identifier: Apache-2.0
// Truncated Taylor numbers against series known in closed form.
#include <orispline/math/jet.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using Jet5 = Jet<double, 5>;

void expect_coefficients(const Jet5& found, const std::array<double, 6>& wanted) {
  for (std::size_t k = 0; k < found.size; ++k)
    EXPECT_NEAR(found.c[k], wanted[k], tolerance::exact * std::max(1.0, std::abs(wanted[k]))) << "order " << k;
}

TEST(Jet, ProductIsTheProductOfPowerSeries) {
  const Jet5 t = Jet5::variable(2.0);

  const Jet5 cube = t * t * t;

  EXPECT_EQ(cube.c, (std::array{8.0, 12.0, 6.0, 1.0, 0.0, 0.0}));
}

TEST(Jet, DerivativeIsNotDividedByTheFactorial) {
  const Jet5 t = Jet5::variable(2.0);
  const Jet5 fourth = t * t * t * t;
  EXPECT_EQ(fourth.derivative(0), 16.0);
  EXPECT_EQ(fourth.derivative(1), 32.0);
  EXPECT_EQ(fourth.derivative(2), 48.0);
  EXPECT_EQ(fourth.derivative(3), 48.0);
  EXPECT_EQ(fourth.derivative(4), 24.0);
}

TEST(Jet, ReciprocalHasTheGeometricSeries) {
  expect_coefficients(1.0 / (1.0 - Jet5::variable(0.0)), {1, 1, 1, 1, 1, 1});
}

TEST(Jet, QuotientUndoesTheProduct) {
  const Jet5 a{.5}, t = Jet5::variable(0.3);
  const Jet5 p = a + 2.0 * t - t * t * t, q = 1.5 + t * t;
  expect_coefficients(p * q / q, p.c);
}

TEST(Jet, SumsAndScalingsActOnEveryOrder) {
  const Jet5 t = Jet5::variable(3.0), p = t * t;
  EXPECT_EQ((p + t).c, (std::array{12.0, 7.0, 1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ((p - t).c, (std::array{6.0, 5.0, 1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ((-p).c, (std::array{-9.0, -6.0, -1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ((p * 2.0).c, (2.0 * p).c);
  EXPECT_EQ((p / 2.0).c, (std::array{4.5, 3.0, 0.5, 0.0, 0.0, 0.0}));
  Jet5 r = p;
  r *= t;
  EXPECT_EQ(r, p * t);
  r /= t;
  expect_coefficients(r, p.c);
}

TEST(Jet, SquareRootHasTheBinomialSeries) {
  expect_coefficients(sqrt_of(1.0 + Jet5::variable(0.0)), {1, 1.0 / 2, -1.0 / 8, 1.0 / 16, -5.0 / 128, 7.0 / 256});
}

TEST(Jet, SineAndCosineHaveTheirSeries) {
  Jet5 sine, cosine;
  sin_cos(Jet5::variable(0.0), sine, cosine);
  expect_coefficients(sine, {0, 1, 0, -1.0 / 6, 0, 1.0 / 120});
  expect_coefficients(cosine, {1, 0, -1.0 / 2, 0, 1.0 / 24, 0});
}

TEST(Jet, SineOfASquareFollowsTheChainRule) {
  Jet5 sine, cosine;
  const Jet5 t = Jet5::variable(0.0);
  sin_cos(t * t, sine, cosine);
  expect_coefficients(sine, {0, 0, 1, 0, 0, 0});
  expect_coefficients(cosine, {1, 0, 0, 0, -1.0 / 2, 0});
}

TEST(Jet, ArcTangentHasItsSeries) {
  expect_coefficients(atan2_of(Jet5::variable(0.0), Jet5(1.0)), {0, 1, 0, -1.0 / 3, 0, 1.0 / 5});
}

TEST(Jet, AngleOfAPointOnACircleIsItsParameter) {
  using std::numbers::pi;
  for (const double angle : {-3.0, -pi / 2, -0.1, 0.0, 1.0, pi / 2, 2.0, 3.1}) {
    Jet5 sine, cosine;
    sin_cos(Jet5::variable(angle), sine, cosine);
    expect_coefficients(atan2_of(3.0 * sine, 3.0 * cosine), {angle, 1, 0, 0, 0, 0});
  }
}

TEST(Jet, NestsForTwoVariables) {
  using Inner = Jet<double, 1>;
  const Jet<Inner, 1> x(Inner::variable(3.0));
  const Jet<Inner, 1> y = Jet<Inner, 1>::variable(Inner(5.0));
  const auto product = x * x * y;
  EXPECT_EQ(product.c[0].c[0], 45.0);
  EXPECT_EQ(product.c[0].c[1], 30.0);  // d/dx
  EXPECT_EQ(product.c[1].c[0], 9.0);   // d/dy
  EXPECT_EQ(product.c[1].c[1], 6.0);   // d²/dxdy
  EXPECT_EQ(value_of(product), 45.0);
}

TEST(Jet, OfOrderZeroIsThePlainNumber) {
  const auto x = Jet<double, 0>::variable(2.0);
  EXPECT_EQ((x * x + 1).c[0], 5.0);
}

}}  // namespace orispline
