// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace orispline { namespace {

TEST(TimeOrigin, GivesTheNearestDoubleOfTheExactSum) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> digits(-1.0, 1.0);
  for (const char* text : {"0", "0.1", "-3.25", "1e-30", "1403636580.838555648", "1700000000.123456789", "218174919753",
                           "8589934592.0000000000001", "-8589934591.9999999999", "1e18", "0.83716123456789115",
                           "4503599627370496.5", "1e140"}) {
    const TimeOrigin origin(Decimal::parse(text).value());
    for (int i = 0; i < 4000; ++i) {
      const double offset = i % 2 == 0 ? i / 1000.0 : digits(random) * std::pow(10.0, i % 40 - 20);
      EXPECT_EQ(origin.nearest_plus(offset), origin.plus(offset).to_double()) << text << " + " << offset;
    }
  }
}

/// Where the shortest decimal has 15 to 17 digits, and at the ends of decades and of binary exponents.
TEST(TimeOrigin, GivesItForOffsetsWithAllDigits) {
  const TimeOrigin origin(Decimal::parse("0.83716123456789115").value());
  std::vector<double> offsets{0x1p-20, 0x1p40, 4503599627370497.5, 9007199254740991.0};
  for (int exponent = -8; exponent <= 17; ++exponent) offsets.push_back(std::pow(10.0, exponent));
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> exponents(-9.0, 17.0);
  for (int i = 0; i < 20000; ++i) offsets.push_back(std::pow(10.0, exponents(random)));
  for (const double center : offsets)
    for (const double offset : {center, std::nextafter(center, 0.0), std::nextafter(center, 1e300), -center})
      ASSERT_EQ(origin.nearest_plus(offset), origin.plus(offset).to_double()) << offset;
}

TEST(TimeOrigin, RoundsOnceWhereTheSumIsHalfwayBetweenDoubles) {
  const TimeOrigin even(Decimal::parse("4503599627.370496").value());  // between doubles that are 2^-20 apart
  const double half = 0x1p-21;
  const Decimal exact = even.plus(half);
  EXPECT_EQ(even.nearest_plus(half), exact.to_double());
  EXPECT_EQ(even.nearest_plus(-half), even.plus(-half).to_double());
}

}}  // namespace orispline
