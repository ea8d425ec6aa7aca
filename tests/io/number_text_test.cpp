// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/number_text.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <orispline/base/decimal.hpp>

namespace orispline { namespace {

std::string text_of(double value) {
  std::array<char, shortest_text_room> text;
  return {text.data(), write_shortest_text(text.data(), value)};
}

void expect_as_formatted(double magnitude) {
  for (const double value : {magnitude, -magnitude}) {
    const std::string text = text_of(value);
    ASSERT_EQ(text, fmt::format("{}", value));
    ASSERT_LE(text.size(), longest_shortest_text);
  }
}

TEST(NumberText, HasAnExponentOnlyBelowOneTenThousandthAndFrom1e16) {
  const std::pair<double, const char*> cases[] = {{0.0, "0"},
                                                  {-0.0, "-0"},
                                                  {1.0, "1"},
                                                  {-12.0, "-12"},
                                                  {1200.0, "1200"},
                                                  {1234.5, "1234.5"},
                                                  {0.1, "0.1"},
                                                  {-0.00012, "-0.00012"},
                                                  {0.00001, "1e-05"},
                                                  {0.000012345678901234567, "1.2345678901234568e-05"},
                                                  {1e15, "1000000000000000"},
                                                  {9007199254740993.0, "9007199254740992"},
                                                  {1e16, "1e+16"},
                                                  {-5e-324, "-5e-324"},
                                                  {std::numeric_limits<double>::max(), "1.7976931348623157e+308"},
                                                  {std::numeric_limits<double>::quiet_NaN(), "nan"},
                                                  {-std::numeric_limits<double>::quiet_NaN(), "nan"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(text_of(value), text);
}

TEST(NumberText, IsThatOfTheFormatLibraryForAnyBits) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t bits = random() >> 1;
    if (const auto value = std::bit_cast<double>(bits); std::isfinite(value)) expect_as_formatted(value);
    expect_as_formatted(std::bit_cast<double>(bits >> (11 + bits % 52)));     // denormals
    expect_as_formatted(static_cast<double>(bits >> (bits % 63)));            // whole numbers
    expect_as_formatted(static_cast<double>(bits % 1'000'000'000) / 4096.0);  // exact binary fractions
  }
}

TEST(NumberText, IsThatOfTheFormatLibraryAroundPowersOfTenAndTwo) {
  const auto expect_around = [](double value) {
    for (const double towards : {0.0, value, 2.0 * value}) expect_as_formatted(std::nextafter(value, towards));
  };
  for (int exponent = -323; exponent < 308; ++exponent)
    for (int digit = 1; digit < 10; ++digit)
      expect_around(std::strtod(fmt::format("{}e{}", digit, exponent).c_str(), nullptr));
  for (int exponent = -1074; exponent < 1023; ++exponent) expect_around(std::ldexp(1.0, exponent));
}

TEST(ShortestDecimal, DoesNotEndInAZero) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 100'000; ++i) {
    const double value = static_cast<double>(random() % 1'000'000'000) * std::pow(10.0, static_cast<int>(i % 40) - 20);
    if (value == 0.0) continue;
    ASSERT_NE(shortest_decimal(value).significand % 10, 0u) << value;
    ASSERT_EQ(Decimal::from_double(-value), Decimal::parse(fmt::format("{}", -value)).value());
  }
}

}}  // namespace orispline
