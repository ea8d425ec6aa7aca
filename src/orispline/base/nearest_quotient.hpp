// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <orispline/base/decimal_digits.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

inline constexpr int largest_power_of_nearest_quotient = 22;

/// The double nearest to numerator / 10^power, halves to even, by whole numbers alone. The numerator is greater than 0,
/// the power from 0 to largest_power_of_nearest_quotient: the quotient has 54 bits then, and the rest tells ties.
[[nodiscard]] inline double nearest_quotient(Integer numerator, int power) noexcept {
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

}}  // namespace orispline
