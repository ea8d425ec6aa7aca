// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <orispline/base/abi.hpp>

// The shortest decimal that reads back as a double, without its digits. V is double or a vector of doubles. In an
// anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace {

/// Numbers from 10^exponent on to below ten times that: what they are multiplied by to have so many digits.
struct Decade {
  double digits15, digits16, digits17;     ///< powers of ten that are doubles
  double inverse15, inverse16, inverse17;  ///< of them, rounded
};

/// Of the exponents whose powers are doubles.
inline constexpr int lowest_decade = -6, highest_decade = 14;

[[nodiscard]] constexpr double power_of_ten(int exponent) noexcept {
  double power = 1.0;
  for (int i = 0; i < exponent; ++i) power *= 10.0;  // exact up to 10^22
  return power;
}

/// The double nearest to 10^exponent, which the decade begins with.
[[nodiscard]] constexpr double least_of_decade(int exponent) noexcept {
  return exponent < 0 ? 1.0 / power_of_ten(-exponent) : power_of_ten(exponent);
}

[[nodiscard]] constexpr Decade decade(int exponent) noexcept {
  const double p15 = power_of_ten(14 - exponent), p16 = power_of_ten(15 - exponent), p17 = power_of_ten(16 - exponent);
  return {p15, p16, p17, 1.0 / p15, 1.0 / p16, 1.0 / p17};
}

template <class V>
struct WholeBits {
  typedef std::int64_t type __attribute__((vector_size(sizeof(V))));
};
template <>
struct WholeBits<double> {
  using type = std::int64_t;
};

template <class To, class From>
[[gnu::always_inline]] inline To same_bits(const From& from) noexcept {
  To to;
  __builtin_memcpy(&to, &from, sizeof to);
  return to;
}

template <class V>
[[gnu::always_inline]] inline V size_of(V x) noexcept {
  return x < 0.0 ? -x : x;
}

/// NaN where there is a doubt, else x.
template <class V, class Condition>
[[gnu::always_inline]] inline V unsure_where(const Condition& doubt, V x) noexcept {
  return doubt ? V{} + __builtin_nan("") : x;
}

/// A whole number as near to x as the unit of 2^52 + |x| allows, from which x is an exact double away.
template <class V>
[[gnu::always_inline]] inline V whole(V x) noexcept {
  constexpr double all_digits = 0x1.8p52;
  return (x + all_digits) - all_digits;
}

/// By how much a product is larger than its rounded value, exact.
template <class V>
[[gnu::always_inline]] inline V product_rest(V a, double b, V rounded) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  if constexpr (sizeof(V) == sizeof(double)) {
    return __builtin_fma(a, b, -rounded);
  } else {
    V rest;
    for (std::size_t i = 0; i < sizeof(V) / sizeof(double); ++i) rest[i] = __builtin_fma(a[i], b, -rounded[i]);
    return rest;
  }
#else
  constexpr double splitter = 0x1p27 + 1.0;  // Veltkamp's halves and Dekker's product, for lack of an instruction
  const V x = splitter * a;
  const double y = splitter * b;
  const V a1 = x - (x - a), a2 = a - a1;
  const double b1 = y - (y - b), b2 = b - b1;
  return ((a1 * b1 - rounded) + a1 * b2 + a2 * b1) + a2 * b2;
#endif
}

/// From x * power to the nearest whole number.
template <class V>
[[gnu::always_inline]] inline V to_whole(V x, double power) noexcept {
  const V product = x * power;
  const V rest = (whole(product) - product) - product_rest(x, power, product);
  return rest - whole(rest);
}

/// A decimal less the double that it stands for, to 2^-50 of that; NaN where it is not sure which decimal it is.
///
/// Of the decimals that read back as x, those within half a unit in its last place, the shortest is wanted, of equally
/// long ones the nearest: one of 15 digits, zeros at the end among them, is alone in so short an interval; else it is
/// the nearest of 16 digits, or of 17, of which there always is one. x: of the decade.
template <class V>
[[gnu::always_inline]] inline V shortest_rest(V x, const Decade& decade) noexcept {
  constexpr double margin = 0x1p-40, nearly_half = 0.5 - 0x1p-30;
  constexpr std::int64_t mantissa_bits = (std::int64_t{1} << 52) - 1;
  using Bits = typename WholeBits<V>::type;
  const Bits bits = same_bits<Bits>(x);
  const V half_unit = same_bits<V>(bits & ~mantissa_bits) * 0x1p-53;
  const V part16 = to_whole(x, decade.digits16), part17 = to_whole(x, decade.digits17);
  const V rest15 = to_whole(x, decade.digits15) * decade.inverse15;
  const V rest16 = part16 * decade.inverse16, rest17 = part17 * decade.inverse17;
  const V from15 = size_of(rest15) - half_unit, from16 = size_of(rest16) - half_unit;
  const V rest = from15 < 0.0 ? rest15 : from16 < 0.0 ? rest16 : rest17;
  const V no_power = unsure_where((bits & mantissa_bits) == 0, rest);  // whose unit is smaller below
  const V clear15 = unsure_where(size_of(from15) < margin * half_unit, no_power);
  const V clear16 = unsure_where(size_of(from16) < margin * half_unit, clear15);
  return unsure_where(size_of(part16) > nearly_half, unsure_where(size_of(part17) > nearly_half, clear16));
}

/// The double nearest to high + low and the shortest decimal of an offset together; NaN where that is not sure.
///
/// `low`: to 2^-53 of itself. `rest`: that of the offset.
template <class V>
[[gnu::always_inline]] inline V nearest_sum(double high, double low, V offset, V rest) noexcept {
  const V sum = high + offset, part = sum - high;  // Knuth's sum with its error
  const V error = (high - (sum - part)) + (offset - part);
  const V all = error + (low + rest);
  const V doubt = 0x1p-49 * (size_of(error) + size_of(V{} + low) + size_of(rest));
  const V least = sum + (all - doubt), most = sum + (all + doubt);
  return unsure_where(least != most, least);
}

}}}  // namespace orispline
