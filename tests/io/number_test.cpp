// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/text_table.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace orispline::io { namespace {

std::string number_refusal(std::string_view cell) {
  const auto number = number_of(cell);
  return number ? "took it as " + std::to_string(*number) : number.error().message;
}

TEST(Number, IsReadCorrectlyRounded) {
  const std::pair<const char*, double> cases[] = {
      {"0", 0.0},         {"+1.5", 1.5},
      {"-.5", -0.5},      {"1.", 1.0},
      {"1e-3", 0.001},    {"1E+3", 1000.0},
      {"5e-324", 5e-324}, {"1.7976931348623157e308", std::numeric_limits<double>::max()},
      {"0.1", 0.1},       {"9007199254740993", 9007199254740992.0}};
  for (const auto& [cell, value] : cases) EXPECT_EQ(number_of(cell).value(), value) << cell;
  EXPECT_TRUE(std::signbit(number_of("-0").value()));
}

TEST(Number, BelowTheRangeOfADoubleIsZero) {
  EXPECT_EQ(number_of("1e-999").value(), 0.0);
  EXPECT_EQ(number_of("-1e-400").value(), 0.0);
}

TEST(Number, BeyondTheRangeOfADoubleIsRefused) {
  for (const char* cell : {"1e999", "-1e999", "+1.8e308"})
    EXPECT_EQ(number_refusal(cell), "found '" + std::string(cell) + "', wanted a number below 1.8e308 in size");
}

TEST(Number, MayBeNaNOrInfiniteInAnyCaseOfLetters) {
  for (const char* cell : {"nan", "NaN", "NAN", "-nan", "+nan", "nan(ind)", "-nan(0x8)", ""})
    EXPECT_TRUE(std::isnan(number_of(cell).value())) << cell;
  for (const char* cell : {"inf", "Inf", "-INF", "infinity", "+inf"})
    EXPECT_TRUE(std::isinf(number_of(cell).value())) << cell;
}

TEST(Number, IsRefusedWhenAnythingElseIsInTheCell) {
  for (const char* cell : {"abc", "0x10", "1,5", "1.5x", "1e", "1.2.3", "--1", "+-1", "+", "-", ".", "1 2", "NA",
                           "null", "1_000", "1e5.0"})
    EXPECT_EQ(number_refusal(cell), "found '" + std::string(cell) + "', wanted a number such as -1.5e-3");
}

TEST(Number, IsShownShortenedAndPrintableWhenRefused) {
  EXPECT_EQ(number_refusal(std::string(1000, 'x')),
            "found '" + std::string(40, 'x') + "...', wanted a number such as -1.5e-3");
  EXPECT_EQ(number_refusal("\x1b[31m"), "found '?[31m', wanted a number such as -1.5e-3");
  EXPECT_EQ(number_refusal(std::string(39, 'x') + "\xC3\xA9"),
            "found '" + std::string(39, 'x') + "...', wanted a number such as -1.5e-3");
}

TEST(Number, IsReadExactlyAsADecimal) {
  EXPECT_EQ(decimal_of("1700000000123456789").value()->to_string(), "1700000000123456789");
  EXPECT_EQ(decimal_of("nan").value(), std::nullopt);
  EXPECT_EQ(decimal_of("-inf").value(), std::nullopt);
  EXPECT_EQ(decimal_of("").value(), std::nullopt);
  EXPECT_EQ(decimal_of("1e999").error().message, "found '1e999', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(decimal_of("abc").error().message, "found 'abc', wanted a number such as -1.5e-3");
}

}}  // namespace orispline::io
