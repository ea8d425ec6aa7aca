// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Decimal number of up to 37 significant digits: time stamps as files write them, without the rounding of a double.
///
/// Sums, differences and products are exact while they need no more than `max_digits`; farther digits are cut off.
/// Comparisons are always exact.
class ORISPLINE_EXPORT Decimal {
 public:
  static constexpr int max_digits = 37;
  /// Parsed numbers are zero or of a size between 10^-limit and 10^limit, so that products stay finite doubles.
  static constexpr int parsed_exponent_limit = 150;

  Decimal() = default;  ///< zero

  /// `-12`, `+1.5`, `.5`, `1e-9`; the whole text, without blanks.
  ///
  /// Errors (bad_data): not such a number, more digits than `max_digits`, out of range.
  [[nodiscard]] static Expected<Decimal> parse(std::string_view text);
  /// The shortest decimal that reads back as the same double. `value` is finite.
  [[nodiscard]] static Decimal from_double(double value);

  /// 10^exponent.
  [[nodiscard]] static Decimal power_of_ten(int exponent) noexcept { return Decimal(1, exponent); }

  /// The nearest double.
  [[nodiscard]] double to_double() const;
  /// That of the first digit: 10^decade ≤ |number| < 10^(decade + 1). Of a number that is not zero.
  [[nodiscard]] int decade() const noexcept;
  [[nodiscard]] bool is_whole() const noexcept { return exponent_ >= 0; }
  /// The nearest number of so many decimals, a whole one by default; halves go away from zero.
  [[nodiscard]] Decimal rounded(int decimals = 0) const noexcept;

  /// All digits, without an exponent: `1311868163.8697`.
  [[nodiscard]] std::string to_string() const;
  /// Appends all digits to a text.
  void append_to(std::string& text) const;

  [[nodiscard]] Decimal operator-() const noexcept { return Decimal(-coefficient_, exponent_); }
  [[nodiscard]] Decimal operator+(const Decimal& other) const noexcept;
  [[nodiscard]] Decimal operator-(const Decimal& other) const noexcept { return *this + -other; }
  [[nodiscard]] Decimal operator*(const Decimal& other) const noexcept;
  struct Quotient;
  /// The exact quotient where `max_digits` are enough, else the nearest that has so many. `divisor` is not zero.
  [[nodiscard]] Quotient divided_by(const Decimal& divisor) const noexcept;
  [[nodiscard]] bool operator==(const Decimal& other) const noexcept = default;
  [[nodiscard]] std::strong_ordering operator<=>(const Decimal& other) const noexcept;

 private:
  __extension__ typedef __int128 Integer;

  struct Aligned;

  Decimal(Integer coefficient, int exponent) noexcept;
  [[nodiscard]] static Aligned aligned(const Decimal& a, const Decimal& b) noexcept;

  // coefficient · 10^exponent; the coefficient does not end in a zero digit, zero is 0 · 10^0.
  Integer coefficient_ = 0;
  int exponent_ = 0;
};

struct Decimal::Quotient {
  Decimal value;
  bool is_exact;
};

/// A quotient of two decimals: rates, scales and intervals as people state them, such as 30000/1001 frames a second.
class ORISPLINE_EXPORT Fraction {
 public:
  /// Decimals that a time has which the fraction cannot make exactly [1e-18 s].
  static constexpr int decimals_of_times = 18;

  Fraction() : Fraction(Decimal::power_of_ten(0)) {}
  Fraction(const Decimal& number)
      : numerator_(number), denominator_(Decimal::power_of_ten(0)) {}  // NOLINT: a number is one
  /// `denominator` is not zero. A quotient that is a decimal is kept as one.
  Fraction(const Decimal& numerator, const Decimal& denominator);

  /// `24`, `23.976`, `1/24`, `30000/1001`; the whole text, without blanks. Error: bad_data.
  [[nodiscard]] static Expected<Fraction> parse(std::string_view text);

  [[nodiscard]] const Decimal& numerator() const noexcept { return numerator_; }
  /// Greater than zero.
  [[nodiscard]] const Decimal& denominator() const noexcept { return denominator_; }
  [[nodiscard]] bool is_positive() const noexcept { return numerator_ > Decimal(); }
  /// Of one that is not zero.
  [[nodiscard]] Fraction inverse() const { return {denominator_, numerator_}; }
  /// The nearest double, but for one more rounding where numerator or denominator is none.
  [[nodiscard]] double to_double() const { return numerator_.to_double() / denominator_.to_double(); }
  /// The product, exact where it is a decimal, else with as many digits as a decimal has.
  [[nodiscard]] Decimal of(const Decimal& number) const noexcept;
  /// The product as a time [s], which is written: `decimals_of_times` at most where it is not exact.
  [[nodiscard]] Decimal time_of(const Decimal& number) const noexcept;
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] bool is_decimal() const noexcept { return denominator_ == Decimal::power_of_ten(0); }

  Decimal numerator_, denominator_;
};

/// An exact time that doubles are counted from.
class ORISPLINE_EXPORT TimeOrigin {
 public:
  explicit TimeOrigin(const Decimal& time);

  [[nodiscard]] const Decimal& time() const noexcept { return time_; }
  /// The exact sum with the shortest decimal of a finite offset.
  [[nodiscard]] Decimal plus(double offset) const { return time_ + Decimal::from_double(offset); }
  /// The double nearest to that sum, mostly without forming it.
  [[nodiscard]] double nearest_plus(double offset) const;

 private:
  Decimal time_;
  bool is_split_;  // whether the time is high_ + low_, to 2^-53 |low_|
  double high_, low_ = 0.0;
};

}}  // namespace orispline
