// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
  /// The same as a time [s], which is written: `decimals_of_times` at most where it is not exact.
  [[nodiscard]] Decimal time_of(const Decimal& number) const noexcept;
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] bool is_decimal() const noexcept { return denominator_ == Decimal::power_of_ten(0); }

  Decimal numerator_, denominator_;
};

}}  // namespace orispline
