// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/elementary.hpp>

#include <cmath>
#include <concepts>

namespace orispline { inline namespace ORISPLINE_ABI {

template <class T, int N>
struct Jet;

/// True for the number types that formulas may be written over: floating point and truncated Taylor numbers.
template <class T>
inline constexpr bool is_number = std::floating_point<T> && sizeof(T) <= sizeof(double);
template <class T, int N>
inline constexpr bool is_number<Jet<T, N>> = is_number<T>;

template <class T>
concept Number = is_number<T>;

template <class T>
struct PlainOf {
  using type = T;
};
template <class T, int N>
struct PlainOf<Jet<T, N>> : PlainOf<T> {};
/// The floating-point type inside a number type: constants of this type scale a jet without a product of series.
template <Number T>
using Plain = typename PlainOf<T>::type;

// The hooks of a number type. They stand here, before any formula, so that two-phase lookup finds them for every type.

template <std::floating_point T>
[[nodiscard]] T sqrt_of(T x) noexcept {
  return std::sqrt(x);
}

// Sine, cosine and arc tangent are not those of <cmath>, whose bits differ from processor to processor. A float goes
// through double.

template <std::floating_point T>
void sin_cos(T x, T& sine, T& cosine) noexcept {
  const auto found = elementary::sine_cosine(static_cast<double>(x));
  sine = static_cast<T>(found.sine);
  cosine = static_cast<T>(found.cosine);
}

template <std::floating_point T>
[[nodiscard]] T atan2_of(T y, T x) noexcept {
  return static_cast<T>(elementary::arctangent(static_cast<double>(y), static_cast<double>(x)));
}

/// The plain number inside: the value without its derivatives. Branches are decided on it.
template <std::floating_point T>
[[nodiscard]] constexpr T value_of(T x) noexcept {
  return x;
}

}}  // namespace orispline
