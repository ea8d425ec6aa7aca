// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/quadrature.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::today;

/// A function of one time as the quadrature asks for it.
template <class F>
auto each(F& f) {
  return [&](std::span<const double> times, std::span<Figures<1>> values) {
    for (std::size_t i = 0; i < times.size(); ++i) values[i] = f(times[i]);
  };
}

template <class F>
double integral(F f, double a, double b) {
  return adaptive_integral<1>(each(f), a, b, Figures<1>(0.0))[0];
}

TEST(Quadrature, HalvesUntilItHasFollowedAPeakThatIsMuchNarrowerThanThePiece) {
  constexpr double width = 0.003, middle = 0.3;
  const auto peak = [](double t) { return width / (width * width + (t - middle) * (t - middle)); };
  const double wanted = std::atan((1.0 - middle) / width) + std::atan(middle / width);
  EXPECT_NEAR(integral(peak, 0.0, 1.0) / wanted, 1.0, 1e-10);
}

TEST(Quadrature, FindsACorner) {
  constexpr double corner = 0.31415;
  const double wanted = 0.5 * (corner * corner + (1.0 - corner) * (1.0 - corner));
  EXPECT_NEAR(integral([](double t) { return std::abs(t - corner); }, 0.0, 1.0) / wanted, 1.0, 1e-11);
}

TEST(Quadrature, LooksIntoNoRounding) {
  std::size_t values = 0;
  const auto rough = [&](double t) {
    ++values;
    return 1.0 + 1e-7 * std::sin(1e12 * t);
  };
  EXPECT_NEAR(integral(rough, 0.0, 1.0), 1.0, 1e-7);
  EXPECT_LT(values, 6 * quadrature_nodes * (std::size_t{1} << most_halvings));
}

TEST(Quadrature, WeighsTheTimesThatANodeIsRoundedTo) {
  for (const double h : {1.0, 1.0 / 64.0, 1.0 / 4096.0}) {
    const auto ninth = [h](double t) { return std::pow((t - today) / h, 9.0); };
    auto at_nodes = each(ninth);
    const auto found = integrals<1, 1>(at_nodes, {Piece{today, today + h}})[0];
    EXPECT_NEAR(found.gauss[0] / h, 0.1, 1e-13);
    EXPECT_NEAR(found.kronrod[0] / h, 0.1, 1e-13);
    const auto wave = [h](double t) { return std::sin(3.0 * (t - today) / h); };
    EXPECT_NEAR(integral(wave, today, today + h) / h, (1.0 - std::cos(3.0)) / 3.0, 1e-11);
  }
}

TEST(Quadrature, IsExactForPolynomialsUpToItsDegreesAndAsManyAsItHasNodesWhereTheseAreRounded) {
  struct Case {
    double start;
    int kronrod, gauss;
  };
  for (const auto& [start, kronrod, gauss] : {Case{0.0, 31, 19}, Case{4e3, 20, 9}, Case{4e6, 20, 9}, Case{4e8, 20, 9}})
    for (int degree = 0; degree <= kronrod; ++degree) {
      const double from = start, wanted = degree % 2 == 0 ? 1.0 / (degree + 1) : 0.0;
      const auto power = [&](double t) { return std::pow(2.0 * (t - from) - 1.0, degree); };
      auto at_nodes = each(power);
      const auto found = integrals<1, 1>(at_nodes, {Piece{start, start + 1.0}})[0];
      EXPECT_NEAR(found.kronrod[0], wanted, 4e-15) << start << ", " << degree;
      EXPECT_NEAR(found.gauss[0], wanted, degree <= gauss ? 4e-15 : 1.0) << start << ", " << degree;
    }
}

TEST(Quadrature, AsksForNoMoreValuesAtTheTimesOfToday) {
  const auto values_for = [](double origin, double h) {
    std::size_t values = 0;
    static_cast<void>(integral(
        [&](double t) {
          ++values;
          return 2.0 + std::sin(9.0 * (t - origin) / h);
        },
        origin, origin + h));
    return values;
  };
  for (const double h : {4.0, 1.0, 1.0 / 64.0, 1.0 / 1024.0}) EXPECT_LE(values_for(today, h), values_for(0.0, h)) << h;
}

TEST(Quadrature, TakesAPieceOfAFewRoundingsOfTimeAsItIs) {
  const double ulp = std::nextafter(today, 2.0 * today) - today;
  for (const double roundings : {1.0, 7.0, 100.0}) {
    std::size_t values = 0;
    const double h = roundings * ulp;
    const auto rising = [&](double t) {
      ++values;
      return (t - today) / h;
    };
    EXPECT_NEAR(integral(rising, today, today + h) / h, 0.5, 0.5 / roundings);
    EXPECT_EQ(values, quadrature_nodes);
  }
}

}}  // namespace orispline
