// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#include <orispline/base/decimal_digits.hpp>
#include <orispline/base/decimal_text.hpp>
#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/nearest_double.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int largest_power_of_nearest_quotient = 22;

/// The double nearest to numerator / 10^power, halves to even, by whole numbers alone. The numerator is greater than 0,
/// the power from 0 to largest_power_of_nearest_quotient: the quotient has 54 bits then, and the rest tells ties.
double nearest_quotient(Integer numerator, int power) noexcept {
  __extension__ typedef unsigned __int128 Wide;
  constexpr int precision = 53;
  const int zeros =
      high_half(numerator) != 0 ? std::countl_zero(high_half(numerator)) : 64 + std::countl_zero(low_half(numerator));
  const Wide dividend = static_cast<Wide>(numerator) << zeros, divisor = static_cast<Wide>(integer_power_of_ten(power));
  const Wide quotient = dividend / divisor;
  const auto high = static_cast<std::uint64_t>(quotient >> 64), low = static_cast<std::uint64_t>(quotient);
  const int bits = static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
  const int dropped = bits - precision;
  const Wide half = Wide{1} << (dropped - 1), rest = quotient & (2 * half - 1);
  auto mantissa = static_cast<std::uint64_t>(quotient >> dropped);
  const bool is_above = rest > half || (rest == half && quotient * divisor != dividend);
  if (is_above || (rest == half && mantissa % 2 == 1)) ++mantissa;
  return std::ldexp(static_cast<double>(mantissa), dropped - zeros);
}

Integer magnitude(Integer value) { return value < 0 ? -value : value; }

/// A number that is not 0 without the zeros that it ends in.
template <class Whole>
struct WithoutZeros {
  Whole value;
  int zeros = 0;

  explicit WithoutZeros(Whole whole) : value(whole) {
    for (; value % 2 == 0 && value % 10 == 0; ++zeros) value /= 10;  // a division of 128 bits is slow
  }
};

/// The value without its last digits, cut toward zero.
Integer cut(Integer value, int digits) {
  return digits > Decimal::max_digits ? Integer{0} : value / integer_power_of_ten(digits);
}

/// Significant digits gathered one by one; zeros count once a digit follows them.
struct Significand {
  static constexpr int short_digits = 18;  // that 64 bits hold: most numbers have no more, and those are fast

  Integer long_value = 0;
  std::int64_t short_value = 0;
  int digits = 0;
  int pending_zeros = 0;

  [[nodiscard]] Integer value() const { return digits <= short_digits ? Integer{short_value} : long_value; }

  void append(int digit) {
    if (digit == 0) {
      if (digits > 0) ++pending_zeros;
      return;
    }
    const int before = digits, added = std::exchange(pending_zeros, 0) + 1;
    digits += added;
    if (digits <= short_digits) {
      short_value = short_value * static_cast<std::int64_t>(integer_power_of_ten(added)) + digit;
    } else if (digits <= Decimal::max_digits) {
      if (before <= short_digits) long_value = short_value;
      long_value = long_value * integer_power_of_ten(added) + digit;
    }
  }
};

/// A number as written: ± significand · 10^exponent.
struct Written : WrittenDecimal {
  Significand significand;
};

/// Nothing for a text that is no decimal number.
std::optional<Written> scan(std::string_view text) {
  Significand significand;
  const auto around = DecimalScanner(text).scan([&significand](int digit) { significand.append(digit); });
  if (!around) return std::nullopt;
  Written written{*around, significand};
  written.exponent += significand.pending_zeros;
  return written;
}

}  // namespace

Decimal::Decimal(Integer coefficient, int exponent) noexcept : coefficient_(coefficient), exponent_(exponent) {
  if (coefficient_ == 0) exponent_ = 0;
  if (const int excess = digits_of(magnitude(coefficient_)) - max_digits; excess > 0) {
    coefficient_ = cut(coefficient_, excess);
    exponent_ += excess;
  }
  if (coefficient_ == 0) return;
  const auto take = [this](const auto& whole) {
    coefficient_ = whole.value;
    exponent_ += whole.zeros;
  };
  if (const auto half = static_cast<std::int64_t>(coefficient_); half == coefficient_) take(WithoutZeros(half));
  else take(WithoutZeros(coefficient_));
}

Expected<Decimal> Decimal::parse(std::string_view text) {
  const auto found = [text](std::string_view wanted) {
    return failure(ErrorCode::bad_data, formatted("found {}, wanted {}", in_quotes(text), wanted));
  };
  const std::optional<Written> written = scan(text);
  if (!written) return found("a number such as -1.5e-3");
  const Significand& significand = written->significand;
  if (significand.digits == 0) return Decimal();
  if (significand.digits > max_digits) return found(formatted("at most {} significant digits", max_digits));
  const std::int64_t size = written->exponent + significand.digits;
  if (size > parsed_exponent_limit || size <= -parsed_exponent_limit)
    return found(formatted("a number between 1e-{0} and 1e{0} in size", parsed_exponent_limit));
  Decimal number;
  number.coefficient_ = written->sign * significand.value();
  number.exponent_ = static_cast<int>(written->exponent);
  return number;
}

Decimal Decimal::from_double(double value) {
  ORISPLINE_EXPECT(std::isfinite(value));
  const ShortestDecimal shortest = shortest_decimal(std::abs(value));
  Decimal number;
  number.coefficient_ = shortest.significand;
  if (value < 0.0) number.coefficient_ = -number.coefficient_;
  if (value != 0.0) number.exponent_ = shortest.exponent;
  return number;
}

double Decimal::to_double() const {
  constexpr Integer largest_exact = Integer{1} << 53;
  constexpr int largest_exact_power = 22;  // 10^22 is a double
  if (magnitude(coefficient_) <= largest_exact && std::abs(exponent_) <= largest_exact_power) {
    const auto coefficient = static_cast<double>(coefficient_);
    const auto power = static_cast<double>(integer_power_of_ten(std::abs(exponent_)));
    return exponent_ < 0 ? coefficient / power : coefficient * power;  // one rounding
  }
  if (exponent_ <= 0 && -exponent_ <= largest_power_of_nearest_quotient) {
    const double size = nearest_quotient(magnitude(coefficient_), -exponent_);
    return coefficient_ < 0 ? -size : size;
  }
  const double size = nearest_double(Digits(magnitude(coefficient_)).text(), exponent_);
  return coefficient_ < 0 ? -size : size;
}

int Decimal::decade() const noexcept { return exponent_ + digits_of(magnitude(coefficient_)) - 1; }

Decimal Decimal::rounded(int decimals) const noexcept {
  if (-exponent_ <= decimals) return *this;
  const Integer tenths = cut(coefficient_, -exponent_ - decimals - 1);
  return Decimal((tenths + (tenths < 0 ? -5 : 5)) / 10, -decimals);
}

std::string Decimal::to_string() const {
  std::string text;
  append_to(text);
  return text;
}

void Decimal::append_to(std::string& text) const {
  const Digits all(magnitude(coefficient_));
  const std::string_view digits = all.text();
  if (coefficient_ < 0) text += '-';
  if (exponent_ >= 0) {
    text.append(digits).append(static_cast<std::size_t>(exponent_), '0');
    return;
  }
  const auto decimals = static_cast<std::size_t>(-exponent_);
  const std::size_t whole = digits.size() - std::min(digits.size(), decimals);
  text.append(digits.substr(0, whole)).append(whole == 0 ? "0." : ".");
  text.append(decimals - (digits.size() - whole), '0').append(digits.substr(whole));
}

struct Decimal::Aligned {
  Integer a, b;
  int exponent;
};

/// Both coefficients for one exponent: the lower one if `max_digits` allow it, else low digits are cut off.
Decimal::Aligned Decimal::aligned(const Decimal& a, const Decimal& b) noexcept {
  if (a.exponent_ == b.exponent_ || b.coefficient_ == 0) return {a.coefficient_, b.coefficient_, a.exponent_};
  if (a.coefficient_ == 0) return {a.coefficient_, b.coefficient_, b.exponent_};
  if (a.exponent_ < b.exponent_) {
    const Aligned swapped = aligned(b, a);
    return {swapped.b, swapped.a, swapped.exponent};
  }
  const int distance = a.exponent_ - b.exponent_;
  const int shift = std::min(distance, max_digits - digits_of(magnitude(a.coefficient_)));
  return {a.coefficient_ * integer_power_of_ten(shift), cut(b.coefficient_, distance - shift), a.exponent_ - shift};
}

Decimal Decimal::operator+(const Decimal& other) const noexcept {
  const auto [a, b, exponent] = aligned(*this, other);
  return Decimal(a + b, exponent);
}

Decimal Decimal::operator*(const Decimal& other) const noexcept {
  Integer a = coefficient_, b = other.coefficient_;
  int exponent = exponent_ + other.exponent_;
  // Factors of n digits together have a product of n or n - 1, and one more than `max_digits` still fits an integer.
  for (int a_digits = digits_of(magnitude(a)), b_digits = digits_of(magnitude(b)); a_digits + b_digits > max_digits + 1;
       ++exponent) {
    if (magnitude(a) > magnitude(b)) a /= 10, --a_digits;
    else b /= 10, --b_digits;
  }
  return Decimal(a * b, exponent);
}

Decimal::Quotient Decimal::divided_by(const Decimal& divisor) const noexcept {
  ORISPLINE_EXPECT(divisor.coefficient_ != 0);
  // Long division, digit by digit: ten times a rest below 10^37 fits an integer.
  const Integer by = magnitude(divisor.coefficient_);
  Integer quotient = magnitude(coefficient_) / by, rest = magnitude(coefficient_) % by;
  int exponent = exponent_ - divisor.exponent_;
  for (; rest != 0 && digits_of(quotient) < max_digits; --exponent) {
    rest *= 10;
    quotient = quotient * 10 + rest / by;
    rest %= by;
  }
  const bool is_exact = rest == 0;
  if (rest >= by - rest) ++quotient;
  return {Decimal((coefficient_ < 0) == (divisor.coefficient_ < 0) ? quotient : -quotient, exponent), is_exact};
}

std::strong_ordering Decimal::operator<=>(const Decimal& other) const noexcept {
  // Digits are cut only from a number that is smaller in size all the same.
  const auto [a, b, exponent] = aligned(*this, other);
  return a <=> b;
}

}}  // namespace orispline
