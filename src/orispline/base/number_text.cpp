// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/number_text.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <orispline/base/decimal_digits.hpp>
#include <orispline/base/decimal_text.hpp>
#include <orispline/base/nearest_double.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_digits = 17;                       // of the shortest decimal of a double
constexpr int least_point = -3, greatest_point = 16;  // digits before the point that are written without an exponent

using EightDigits = std::array<char, 8>;

/// The digits of a number below 10^8, side by side in one register: halves, quarters, then digits by a multiplication
/// each.
EightDigits eight_digits(std::uint64_t number) {
  constexpr std::uint64_t per_10000 = 3518437209, per_100 = 10486, per_10 = 103;  // reciprocals, · 2^45, 2^20, 2^10
  const std::uint64_t thousands = (number * per_10000) >> 45;
  const std::uint64_t halves = thousands | (number - thousands * 10000) << 32;
  const std::uint64_t hundreds = ((halves * per_100) >> 20) & 0x0000007F'0000007F;
  const std::uint64_t quarters = hundreds | (halves - hundreds * 100) << 16;
  const std::uint64_t tens = ((quarters * per_10) >> 10) & 0x000F000F'000F000F;
  const std::uint64_t digits = tens | (quarters - tens * 10) << 8;
  auto text = std::bit_cast<EightDigits>(digits | 0x30303030'30303030);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(text);
  return text;
}

/// The digits of a number that is not 0, followed by zeros to `most_digits`.
class LeadingDigits {
 public:
  explicit LeadingDigits(std::uint64_t number) : count_(digits_of(number)) {
    constexpr std::uint64_t eight = 100'000'000;
    const std::uint64_t filled = number * low_half(integer_power_of_ten(most_digits - count_));
    const std::uint64_t first_nine = filled / eight;
    first_ = static_cast<char>('0' + first_nine / eight);
    next_ = eight_digits(first_nine % eight);
    last_ = eight_digits(filled % eight);
  }

  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] char first() const noexcept { return first_; }
  void write(char* to) const noexcept {
    *to = first_;
    write_all_but_first(to + 1);
  }
  void write_all_but_first(char* to) const noexcept {
    std::memcpy(to, next_.data(), next_.size());
    std::memcpy(to + next_.size(), last_.data(), last_.size());
  }

 private:
  int count_;
  char first_;
  EightDigits next_, last_;
};

/// `0.0012`; `point`: the digits before the point, none or fewer.
char* write_below_one(char* to, const LeadingDigits& digits, int point) {
  std::copy_n("0.000", 5, to);
  to += 2 - point;
  digits.write(to);
  return to + digits.count();
}

/// `1.2`; the first digit is the one before the point.
char* write_units(char* to, const LeadingDigits& digits) {
  to[0] = digits.first();
  to[1] = '.';
  digits.write_all_but_first(to + 2);
  return to + (digits.count() == 1 ? 1 : 1 + digits.count());
}

/// `12.3`, or `1200` where no digit is behind the point.
char* write_above_one(char* to, const LeadingDigits& digits, int point) {
  digits.write(to);
  if (digits.count() <= point) return to + point;
  std::array<char, std::size_t{2} * most_digits> text;
  digits.write(text.data());
  to[point] = '.';
  std::memcpy(to + point + 1, text.data() + point, most_digits - 1);
  return to + digits.count() + 1;
}

/// `1.2e-05`
char* write_with_exponent(char* to, const LeadingDigits& digits, int exponent) {
  char* end = write_units(to, digits);
  *end++ = 'e';
  *end++ = exponent < 0 ? '-' : '+';
  const int size = std::abs(exponent);
  if (size >= 100) *end++ = static_cast<char>('0' + size / 100);
  *end++ = static_cast<char>('0' + size / 10 % 10);
  *end++ = static_cast<char>('0' + size % 10);
  return end;
}

}  // namespace

// fmt's search for the shortest digits (Dragonbox) takes half the time of `std::to_chars`, and has no public name.
ShortestDecimal shortest_decimal(double magnitude) noexcept {
  const auto decimal = fmt::detail::dragonbox::to_decimal(magnitude);
  return {decimal.significand, decimal.exponent};
}

char* write_shortest_text(char* to, double value) {
  if (std::isnan(value)) return std::ranges::copy(std::string_view("nan"), to).out;
  *to = '-';
  to += std::signbit(value) ? 1 : 0;
  if (value == 0.0) {
    *to = '0';
    return to + 1;
  }
  const auto [significand, exponent] = shortest_decimal(std::abs(value));
  const LeadingDigits digits(significand);
  const int point = digits.count() + exponent;
  if (point < least_point || point > greatest_point) return write_with_exponent(to, digits, point - 1);
  if (point <= 0) return write_below_one(to, digits, point);
  return point == 1 ? write_units(to, digits) : write_above_one(to, digits, point);
}

std::optional<double> number_in(std::string_view text) {
  std::string digits;
  const auto written = DecimalScanner(text).scan([&digits](int digit) { digits += static_cast<char>('0' + digit); });
  if (!written) return std::nullopt;
  const double number = written->sign * nearest_double(digits, written->exponent);
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}}  // namespace orispline
