// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <io/exact_number.hpp>

namespace orispline { namespace {

using test::decimal;

std::string decimal_refusal(std::string_view text) {
  const auto number = Decimal::parse(text);
  return number ? "took it as " + number->to_string() : number.error().message;
}

TEST(Decimal, ReadsEveryWayOfWritingANumber) {
  const std::pair<const char*, const char*> cases[] = {
      {"0", "0"},
      {"-0", "0"},
      {"0e999", "0"},
      {"007", "7"},
      {"+1.5", "1.5"},
      {"-1.5", "-1.5"},
      {".5", "0.5"},
      {"5.", "5"},
      {"1e3", "1000"},
      {"1E+3", "1000"},
      {"-12.5e-3", "-0.0125"},
      {"1.50", "1.5"},
      {"100", "100"},
      {"1200.00e-2", "12"},
      {"0.000", "0"},
      {"1.7e9", "1700000000"},
      {"1e-30", "0.000000000000000000000000000001"},
      {"1311868163.869700", "1311868163.8697"},
      {"1234567890123456789", "1234567890123456789"},
      {"1234567890123456789012345678901234567", "1234567890123456789012345678901234567"}};
  for (const auto& [text, plain] : cases) EXPECT_EQ(decimal(text).to_string(), plain) << text;
}

TEST(Decimal, RefusesWhatIsNoNumber) {
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", "0x10", "nan", "inf", " 1", "1 ",
                           "1_000", "--1", "+-1", "1f"})
    EXPECT_EQ(decimal_refusal(text), "found '" + std::string(text) + "', wanted a number such as -1.5e-3");
}

TEST(Decimal, RefusesWhatItCannotHoldExactly) {
  EXPECT_EQ(decimal_refusal("12345678901234567890123456789012345678"),
            "found '12345678901234567890123456789012345678', wanted at most 37 significant digits");
  EXPECT_EQ(decimal_refusal("1e150"), "found '1e150', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(decimal_refusal("-1e-151"), "found '-1e-151', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(decimal_refusal("1e99999999999999999999"),
            "found '1e99999999999999999999', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(decimal("9.99e149").to_double(), 9.99e149);
  EXPECT_EQ(decimal("1e-150").to_double(), 1e-150);
}

TEST(Decimal, SubtractsWhereDoublesWouldRound) {
  EXPECT_EQ((decimal("1311868163.8731") - decimal("1311868163.8697")).to_double(), 0.0034);
  EXPECT_EQ((decimal("1700000000.123456789") - decimal("1700000000")).to_double(), 0.123456789);
  EXPECT_EQ((decimal("1700000000123456789") - decimal("1700000000123456788")).to_string(), "1");
  EXPECT_EQ((decimal("-3.25") - decimal("-3.5")).to_string(), "0.25");
  EXPECT_EQ((decimal("5") - decimal("5.0")).to_string(), "0");
}

TEST(Decimal, AddsAndMultipliesExactly) {
  EXPECT_EQ((decimal("0.1") + decimal("0.2")).to_string(), "0.3");
  EXPECT_EQ((decimal("99.5") + decimal("0.5")).to_string(), "100");
  EXPECT_EQ((decimal("218174919776.55994") * decimal("0.00390625")).to_string(), "852245780.377187265625");
  EXPECT_EQ((decimal("-250") * decimal("1e-9")).to_string(), "-0.00000025");
  EXPECT_EQ((decimal("0") * decimal("1e100")).to_string(), "0");
}

TEST(Decimal, ProductsOfAsManyDigitsAsThereIsRoomForAreExact) {
  const Decimal a = decimal("1100000000000000001"), b = decimal("1000000000000000003");
  EXPECT_EQ((a * b).to_string(), "1100000000000000004300000000000000003");
}

TEST(Decimal, ProductsDoNotDependOnTheOrderOfTheFactors) {
  const Decimal a = decimal("1123456789012345678901234567"), b = decimal("9007456789012345678901993");
  const Decimal c = decimal("-1999999999999999999"), d = decimal("9111111111111111111");
  EXPECT_EQ(a * b, b * a);
  EXPECT_EQ(c * d, d * c);
}

TEST(Decimal, KnowsTheDecadeOfItsFirstDigit) {
  for (const auto& [text, decade] :
       {std::pair("1", 0), {"9.99", 0}, {"10", 1}, {"-1234.5", 3}, {"0.1", -1}, {"0.00999", -3}, {"1e-150", -150}})
    EXPECT_EQ(decimal(text).decade(), decade) << text;
  EXPECT_EQ(Decimal::from_double(std::numeric_limits<double>::max()).decade(), 308);
  EXPECT_EQ(Decimal::from_double(std::numeric_limits<double>::denorm_min()).decade(), -324);
}

TEST(Decimal, CutsOnlyDigitsBeyondThe37th) {
  EXPECT_EQ((decimal("1e100") + decimal("1")).to_double(), 1e100);
  EXPECT_EQ((decimal("1") + decimal("1e-36")).to_string(), "1.000000000000000000000000000000000001");
  EXPECT_EQ((decimal("1") + decimal("1e-37")).to_string(), "1");
  EXPECT_EQ((decimal("9999999999999999999999999999999999999") + decimal("1")).to_double(), 1e37);
  EXPECT_EQ((decimal("1234567890123456789012345678901234567") * decimal("3")).to_double(), 3.703703670370370367e36);
  EXPECT_EQ((decimal("3") * decimal("1234567890123456789012345678901234567")).to_double(), 3.703703670370370367e36);
}

TEST(Decimal, ComparesExactly) {
  EXPECT_EQ(decimal("1.50"), decimal("15e-1"));
  EXPECT_LT(decimal("1"), decimal("1.000000000000000000000000000000000001"));
  EXPECT_LT(decimal("-2"), decimal("-1"));
  EXPECT_LT(decimal("-1e-100"), decimal("0"));
  EXPECT_LT(decimal("0"), decimal("1e-150"));
  EXPECT_LT(decimal("0"), decimal("1e140"));
  EXPECT_LT(decimal("9e99"), decimal("1e100"));
  EXPECT_GT(decimal("1e149"), decimal("9999999999999999999999999999999999999"));
}

TEST(Decimal, GivesTheNearestDouble) {
  std::mt19937_64 random(20240501);
  for (int i = 0; i < 20000; ++i) {
    const int digits = std::uniform_int_distribution<int>(1, 36)(random);
    std::string text = i % 2 ? "-" : "";
    for (int d = 0; d < digits; ++d) text += static_cast<char>('0' + std::uniform_int_distribution<int>(0, 9)(random));
    text.insert(text.size() - static_cast<std::size_t>(std::uniform_int_distribution<int>(0, digits)(random)), ".");
    text += "e" + std::to_string(std::uniform_int_distribution<int>(-60, 60)(random));
    EXPECT_EQ(decimal(text).to_double(), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Decimal, GivesTheNearestDoubleOfLongNumbersBesideTies) {
  std::mt19937_64 dice(11);
  for (int i = 0; i < 20000; ++i) {
    // Halfway between two doubles m / 2^k, which has as many decimals as bits behind the point, and next to it.
    const auto mantissa = static_cast<double>((dice() >> 11) | (std::uint64_t{1} << 52));
    const double x = std::ldexp(mantissa, -static_cast<int>(50 + dice() % 13));
    const Decimal low = Decimal::from_double(x), high = Decimal::from_double(std::nextafter(x, 1e300));
    const Decimal middle = (low + high) * decimal("0.5");
    for (const char* step : {"0", "1e-21", "-1e-21", "1e-19", "-1e-19"}) {
      const Decimal number = middle + decimal(step);
      const double wanted = std::strtod(number.to_string().c_str(), nullptr);
      EXPECT_EQ(number.to_double(), wanted) << number.to_string();
      EXPECT_EQ((-number).to_double(), -wanted) << number.to_string();
    }
  }
  for (int power = 0; power <= 22; ++power)
    for (const char* digits : {"9007199254740993", "18014398509481985", "9007199254740995", "9999999999999999999999999",
                               "1234567890123456789012345678901234567", "36893488147419107329"}) {
      const std::string text = digits + ("e-" + std::to_string(power));
      EXPECT_EQ(decimal(text).to_double(), std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(Decimal, HoldsEveryDouble) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) {
      EXPECT_EQ(Decimal::from_double(value).to_double(), value);
    }
  }
  for (const double value : {0.0, 0.1, 1.0 / 3.0, std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::max(), -std::numeric_limits<double>::min(), 1e22, 1e23})
    EXPECT_EQ(Decimal::from_double(value).to_double(), value);
}

TEST(Decimal, WritesTheShortestDigitsOfADouble) {
  EXPECT_EQ(Decimal::from_double(0.1).to_string(), "0.1");
  EXPECT_EQ(Decimal::from_double(1e-7).to_string(), "0.0000001");
  EXPECT_EQ(Decimal::from_double(1e21).to_string(), "1000000000000000000000");
  EXPECT_EQ(Decimal::from_double(-0.0).to_string(), "0");
}

TEST(Decimal, WritesEveryDigitOfNumbersOfAnyLength) {
  std::string nines, power = "1";
  for (int digits = 1; digits <= Decimal::max_digits; ++digits, power += '0') {
    nines += '9';
    const std::string odd = digits == 1 ? "1" : power.substr(0, power.size() - 1) + "1";  // zeros between
    EXPECT_EQ(decimal(nines).to_string(), nines);
    EXPECT_EQ(decimal(odd).to_string(), odd);
    EXPECT_EQ(decimal("-." + odd).to_string(), "-0." + odd);
    EXPECT_EQ((decimal(power) + decimal("-1") + decimal("1")).to_string(), power);
  }
}

TEST(Decimal, RoundsToTheNearestWholeNumber) {
  const auto rounded = [](std::string_view text) { return Decimal::parse(text)->rounded().to_string(); };
  for (const auto& [text, wanted] : {std::pair("0", "0"),
                                     {"7", "7"},
                                     {"1200", "1200"},
                                     {"0.4999999999999999999", "0"},
                                     {"0.5", "1"},
                                     {"-0.5", "-1"},
                                     {"-0.49", "0"},
                                     {"2.5", "3"},
                                     {"-2.5", "-3"},
                                     {"1e-40", "0"},
                                     {"1403636580838555648.75", "1403636580838555649"}})
    EXPECT_EQ(rounded(text), wanted) << text;
  EXPECT_TRUE(Decimal::parse("1.50e1")->is_whole());
  EXPECT_TRUE(Decimal::parse("0.0")->is_whole());
  EXPECT_FALSE(Decimal::parse("1.05e1")->is_whole());
}

}}  // namespace orispline
