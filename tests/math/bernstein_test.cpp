// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/bernstein.hpp>

#include <numeric>

#include <gtest/gtest.h>

#include <orispline/math/jet.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

TEST(Bernstein, HasTheValuesOfTheBinomialDistribution) {
  const auto basis = bernstein_basis<4>(0.25);  // C(4,i) 3^(4-i) / 4^4
  const std::array wanted{81.0 / 256, 108.0 / 256, 54.0 / 256, 12.0 / 256, 1.0 / 256};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(basis[i], wanted[i]);
}

TEST(Bernstein, SumsToOneWithDerivativeZero) {
  const auto basis = bernstein_basis<7>(Jet<double, 3>::variable(0.3));
  const auto sum = std::accumulate(basis.begin(), basis.end(), Jet<double, 3>(0.0));
  EXPECT_NEAR(sum.c[0], 1.0, tolerance::exact);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(sum.c[k], 0.0, tolerance::algebra);
}

TEST(Bernstein, TakesItsEndCoefficientsExactly) {
  const std::array<std::array<double, 4>, 2> coefficients{{{0.1, 2.0, -3.0, 0.7}, {1.0, 1.5, 1.0, 1.0}}};
  EXPECT_EQ((bernstein_sums<2, 4>(coefficients, 0.0)), (std::array{0.1, 1.0}));
  EXPECT_EQ((bernstein_sums<2, 4>(coefficients, 1.0)), (std::array{0.7, 1.0}));
}

TEST(Bernstein, EndDerivativesAreDegreeTimesTheFirstDifference) {
  const std::array<std::array<double, 4>, 1> coefficients{{{0.1, 2.0, -3.0, 0.7}}};
  const auto at = [&coefficients](double u) {
    return bernstein_sums<1, 4>(coefficients, Jet<double, 1>::variable(u))[0];
  };
  EXPECT_DOUBLE_EQ(at(0.0).c[1], 3.0 * (2.0 - 0.1));
  EXPECT_DOUBLE_EQ(at(1.0).c[1], 3.0 * (0.7 + 3.0));
}

}}  // namespace orispline
