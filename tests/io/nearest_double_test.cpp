// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/nearest_double.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <orispline/base/number_text.hpp>

namespace orispline { namespace {

/// As the C library reads the same number, which rounds correctly.
void expect_as_read(const std::string& digits, int exponent) {
  const double wanted = std::strtod(fmt::format("{}e{}", digits, exponent).c_str(), nullptr);
  ASSERT_EQ(std::bit_cast<std::uint64_t>(nearest_double(digits, exponent)), std::bit_cast<std::uint64_t>(wanted))
      << digits << "e" << exponent;
}

TEST(NearestDouble, IsThatOfTheCLibraryForAnyDigits) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 20'000; ++i) {
    std::string digits;
    for (std::size_t count = 1 + random() % 40; count > 0; --count) digits += static_cast<char>('0' + random() % 10);
    expect_as_read(digits, static_cast<int>(random() % 700) - 370);
  }
}

TEST(NearestDouble, IsFoundAtTheEndsOfTheRange) {
  expect_as_read("17976931348623157", 292);
  expect_as_read("1797693134862315807", 290);  // below half-way to what would be the next one
  expect_as_read("17976931348623158080", 289);
  expect_as_read("49406564584124654", -340);
  expect_as_read("24703282292062327", -340);  // below half of the least one
  expect_as_read("24703282292062328", -340);
  expect_as_read("22250738585072011", -324);
  expect_as_read("1", -324);
  expect_as_read("9", -325);
  EXPECT_EQ(nearest_double("1", 309), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest_double("1", 1'000'000'000), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest_double("1", -1'000'000'000), 0.0);
  EXPECT_EQ(nearest_double("000", 12), 0.0);
  EXPECT_EQ(nearest_double("", 0), 0.0);
}

/// All digits of the number half-way from a double to the next, which has up to 767 of them.
std::string half_way_digits(double value, int& exponent) {
  const double next = std::nextafter(value, std::numeric_limits<double>::infinity());
  const long double half_way = (static_cast<long double>(value) + static_cast<long double>(next)) / 2;
  std::string text(2000, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.1000Le", half_way)));
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, 1) + text.substr(2, e - 2);
  digits.resize(digits.find_last_not_of('0') + 1);
  exponent = std::stoi(text.substr(e + 1)) - static_cast<int>(digits.size()) + 1;
  return digits;
}

TEST(NearestDouble, IsEvenHalfWayBetweenTwo) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no wider numbers here";
  std::mt19937_64 random(12);
  for (int i = 0; i < 300; ++i) {
    const auto value = std::bit_cast<double>(random() % 0x7fe0000000000000U >> (i % 3 == 0 ? 12 : 0));
    int exponent = 0;
    const std::string digits = half_way_digits(value, exponent);
    const double next = std::nextafter(value, std::numeric_limits<double>::infinity());
    const double even = std::bit_cast<std::uint64_t>(value) % 2 == 0 ? value : next;
    EXPECT_EQ(nearest_double(digits, exponent), even) << digits;
    EXPECT_EQ(nearest_double(digits + std::string(900, '0') + "1", exponent - 901), next) << digits;
    EXPECT_EQ(nearest_double(digits.substr(0, digits.size() - 1), exponent + 1), value) << digits;
  }
}

TEST(NumberIn, IsTheWholeTextOrNone) {
  for (const char* text : {"", " 1", "1 ", ".", "-", "+", "1e", "1e+", "1e400", "-1e400", "0x10", "nan", "inf", "1,5",
                           "1.2.3", "--1", "1e5.0", "12a"})
    EXPECT_EQ(number_in(text), std::nullopt) << text;
  EXPECT_EQ(number_in(std::string_view("1\0", 2)), std::nullopt);
  EXPECT_EQ(number_in("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(number_in("+1."), 1.0);
  EXPECT_EQ(number_in(".5E2"), 50.0);
  EXPECT_EQ(number_in("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(number_in("-0").value()));
  EXPECT_EQ(number_in("0.1000000000000000055511151231257827021181583404541015625"), 0.1);
}

}}  // namespace orispline
