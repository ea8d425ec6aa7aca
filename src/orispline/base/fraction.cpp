// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal.hpp>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whether its products with parsed numbers are finite doubles, as those of two such numbers are.
bool is_in_reach(const Fraction& fraction) {
  const Decimal quotient = fraction.of(Decimal::power_of_ten(0));
  const Decimal size = quotient < Decimal() ? -quotient : quotient;
  return size == Decimal() || (size > Decimal::power_of_ten(-Decimal::parsed_exponent_limit) &&
                               size < Decimal::power_of_ten(Decimal::parsed_exponent_limit));
}

}  // namespace

Fraction::Fraction(const Decimal& numerator, const Decimal& denominator)
    : numerator_(numerator), denominator_(denominator) {
  ORISPLINE_EXPECT(denominator != Decimal());
  if (denominator_ < Decimal()) {
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }
  const auto [quotient, is_exact] = numerator_.divided_by(denominator_);
  if (!is_exact) return;
  numerator_ = quotient;
  denominator_ = Decimal::power_of_ten(0);
}

Expected<Fraction> Fraction::parse(std::string_view text) {
  const std::size_t stroke = text.find('/');
  const auto numerator = Decimal::parse(text.substr(0, stroke));
  if (stroke == std::string_view::npos && numerator) return Fraction(*numerator);
  const auto denominator = stroke == std::string_view::npos ? numerator : Decimal::parse(text.substr(stroke + 1));
  if (numerator && denominator && *denominator != Decimal())
    if (const Fraction fraction(*numerator, *denominator); is_in_reach(fraction)) return fraction;
  return failure(ErrorCode::bad_data,
                 formatted("found {}, wanted a number such as 25, or a fraction such as 30000/1001", in_quotes(text)));
}

Decimal Fraction::of(const Decimal& number) const noexcept {
  const Decimal product = number * numerator_;
  return is_decimal() ? product : product.divided_by(denominator_).value;
}

Decimal Fraction::time_of(const Decimal& number) const noexcept {
  if (is_decimal()) return of(number);
  const auto [time, is_exact] = (number * numerator_).divided_by(denominator_);
  return is_exact ? time : time.rounded(decimals_of_times);
}

std::string Fraction::to_string() const {
  return is_decimal() ? numerator_.to_string() : formatted("{}/{}", numerator_.to_string(), denominator_.to_string());
}

}}  // namespace orispline
