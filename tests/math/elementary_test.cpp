// SPDX-License-Identifier: Apache-2.0
// Sine, cosine, arc tangent, exponential and logarithm: within 1 ulp of true values, symmetric, and with the same bits
// everywhere.
#include <orispline/math/number.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <support/data_table.hpp>

namespace orispline::elementary { namespace {

using testing_support::DataTable;

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// In units in the last place of the wanted double; `rest` is what the true value has beyond that.
double error_in_ulp(double found, double wanted, double rest) {
  const double size = std::abs(wanted);
  return std::abs((found - wanted) - rest) / (std::nextafter(size, infinity) - size);
}

template <class F>
void expect_within_an_ulp(const std::string& name, std::size_t least_rows, F function) {
  const DataTable table("elementary.csv");
  const auto rows = table.rows_where("function", name);
  ASSERT_GT(rows.size(), least_rows);
  for (const auto& row : rows) {
    const double x = row.number("x"), y = row.number("y");
    EXPECT_LE(error_in_ulp(function(x, y), row.number("wanted"), row.number("rest")), 1.0)
        << name << " of x = " << row.text("x") << ", y = " << row.text("y");
  }
}

TEST(Elementary, SineIsWithinAnUlp) {
  expect_within_an_ulp("sin", 900, [](double x, double) { return sine_cosine(x).sine; });
}

TEST(Elementary, CosineIsWithinAnUlp) {
  expect_within_an_ulp("cos", 900, [](double x, double) { return sine_cosine(x).cosine; });
}

TEST(Elementary, ArcTangentIsWithinAnUlp) {
  expect_within_an_ulp("atan2", 600, [](double x, double y) { return arctangent(y, x); });
}

TEST(Elementary, LogarithmIsWithinAnUlp) {
  expect_within_an_ulp("log", 300, [](double x, double) { return natural_logarithm(x); });
}

TEST(Elementary, ExponentialIsWithinAnUlp) {
  expect_within_an_ulp("exp", 350, [](double x, double) { return exponential(x); });
}

/// Finite doubles of either sign from 2^-40 to 2^40, without a function of the system's library.
class Arguments {
 public:
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const std::uint64_t sign_and_fraction = state_ & 0x800fffffffffffff, exponent = 983 + (state_ >> 52 & 0x7ff) % 81;
    return std::bit_cast<double>(sign_and_fraction | exponent << 52);
  }

 private:
  std::uint64_t state_ = 20240229;
};

TEST(Elementary, SineIsOddCosineIsEvenAndTheirSquaresAddUpToOne) {
  Arguments arguments;
  for (int i = 0; i < 20000; ++i) {
    const double x = arguments.next();
    const auto [sine, cosine] = sine_cosine(x);
    const auto mirrored = sine_cosine(-x);
    ASSERT_EQ(bits(mirrored.sine), bits(-sine)) << x;
    ASSERT_EQ(bits(mirrored.cosine), bits(cosine)) << x;
    ASSERT_NEAR(sine * sine + cosine * cosine, 1.0, 4.5e-16) << x;
  }
}

TEST(Elementary, ArcTangentIsOddAndBlindToScale) {
  Arguments arguments;
  for (int i = 0; i < 20000; ++i) {
    const double y = arguments.next(), x = arguments.next(), angle = arctangent(y, x);
    ASSERT_EQ(bits(arctangent(-y, x)), bits(-angle)) << y << " " << x;
    for (const double scale : {0x1p-900, 0x1p-40, 0x1p40, 0x1p900})
      ASSERT_EQ(bits(arctangent(y * scale, x * scale)), bits(angle)) << y << " " << x;
  }
}

TEST(Elementary, ArcTangentReturnsTheAngle) {
  for (int i = -3140; i <= 3140; ++i) {
    const double angle = i / 1000.0;
    const auto [sine, cosine] = sine_cosine(angle);
    EXPECT_NEAR(arctangent(sine, cosine), angle, 4.5e-16);
  }
}

TEST(Elementary, SinesAndCosinesOfThreeAnglesHaveTheBitsOfEach) {
  const std::array angles{0.0, 1e-300, 0x1p-27, 0.3,  -0.3, 0.785398163397448, 0.7853981633974484,
                          1.6, -4.0,   999.0,   1e10, 0.1,  infinity,          nan};
  for (const double a : angles)
    for (const double b : angles)
      for (const double c : angles) {
        const auto found = sines_cosines({a, b, c});
        for (const auto& [angle, of_three] : {std::pair(a, found[0]), std::pair(b, found[1]), std::pair(c, found[2])}) {
          if (!std::isfinite(angle)) {
            ASSERT_TRUE(std::isnan(of_three.sine) && std::isnan(of_three.cosine)) << angle;
            continue;
          }
          ASSERT_EQ(bits(of_three.sine), bits(sine_cosine(angle).sine)) << a << " " << b << " " << c;
          ASSERT_EQ(bits(of_three.cosine), bits(sine_cosine(angle).cosine)) << a << " " << b << " " << c;
        }
      }
}

TEST(Elementary, SineAndCosineAnswerLimitsLikeTheSystem) {
  for (const double x : {0.0, -0.0, std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::min()}) {
    EXPECT_EQ(bits(sine_cosine(x).sine), bits(x));
    EXPECT_EQ(sine_cosine(x).cosine, 1.0);
  }
  for (const double x : {infinity, -infinity, nan}) {
    EXPECT_TRUE(std::isnan(sine_cosine(x).sine)) << x;
    EXPECT_TRUE(std::isnan(sine_cosine(x).cosine)) << x;
  }
}

TEST(Elementary, ArcTangentAnswersLimitsLikeTheSystem) {
  const double least = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();
  for (const double y : {0.0, -0.0, 1.0, -1.0, least, -least, largest, -largest, infinity, -infinity, nan})
    for (const double x : {0.0, -0.0, 1.0, -1.0, least, -least, largest, -largest, infinity, -infinity, nan}) {
      const double wanted = std::atan2(y, x), found = arctangent(y, x);
      if (std::isnan(wanted)) EXPECT_TRUE(std::isnan(found)) << y << " " << x;
      else EXPECT_EQ(bits(found), bits(wanted)) << y << " " << x;
    }
}

TEST(Elementary, LogarithmAnswersLimitsLikeTheSystem) {
  EXPECT_EQ(natural_logarithm(0.0), -infinity);
  EXPECT_EQ(natural_logarithm(-0.0), -infinity);
  EXPECT_EQ(natural_logarithm(infinity), infinity);
  EXPECT_EQ(bits(natural_logarithm(1.0)), bits(0.0));
  for (const double x : {-1.0, -infinity, nan}) EXPECT_TRUE(std::isnan(natural_logarithm(x))) << x;
}

TEST(Elementary, ExponentialAnswersLimitsLikeTheSystem) {
  for (const double x : {0.0, -0.0, 746.0, -746.0, 710.0, -1e300, infinity, -infinity})
    EXPECT_EQ(bits(exponential(x)), bits(std::exp(x))) << x;
  EXPECT_TRUE(std::isnan(exponential(nan)));
}

TEST(Elementary, ExponentialUndoesTheLogarithm) {
  Arguments arguments;
  for (int i = 0; i < 20000; ++i) {
    const double x = std::abs(arguments.next()), logarithm = natural_logarithm(x);
    ASSERT_NEAR(exponential(logarithm) / x, 1.0, 2.3e-16 * (std::abs(logarithm) + 2.0)) << x;
  }
}

TEST(Elementary, HasTheCommittedBits) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, by words
  const auto add = [&](double x) { hash = (hash ^ bits(x)) * 0x100000001b3; };
  Arguments arguments;
  for (int i = 0; i < 20000; ++i) {
    const double x = arguments.next(), y = arguments.next();
    const auto [sine, cosine] = sine_cosine(x);
    add(sine);
    add(cosine);
    add(arctangent(y, x));
    add(natural_logarithm(std::abs(x)));
  }
  EXPECT_EQ(hash, 0xfe800621c9a9eb03);
  for (int i = 0; i < 20000; ++i) add(exponential(std::remainder(arguments.next(), 700.0)));
  EXPECT_EQ(hash, 0x96b3b7717817ed01);
}

}}  // namespace orispline::elementary
