// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <concepts>

#include <orispline/base/abi.hpp>

/// Elementary functions with the same bits on every processor and from every compiler: IEEE operations alone, where the
/// system's library takes other paths on processors with fused multiply-add.
///
/// Each result is within 1 ulp of the true value, for every argument; zeros, infinities and NaN are answered as by
/// `<cmath>`. The formulas: docs/conventions.md, "The same bits everywhere".

namespace orispline { inline namespace ORISPLINE_ABI { namespace elementary {

struct SineCosine {
  double sine, cosine;
};

/// Sine and cosine of an angle [rad] of any size.
[[nodiscard]] ORISPLINE_EXPORT SineCosine sine_cosine(double angle) noexcept;

/// Of three angles at once: none waits for another.
[[nodiscard]] ORISPLINE_EXPORT std::array<SineCosine, 3> sines_cosines(const std::array<double, 3>& angles) noexcept;

/// Angle of the vector (x, y) from the x axis [rad], in [-π, π], with the sign of y.
[[nodiscard]] ORISPLINE_EXPORT double arctangent(double y, double x) noexcept;

/// e^x.
[[nodiscard]] ORISPLINE_EXPORT double exponential(double x) noexcept;

/// Logarithm to the base e.
[[nodiscard]] ORISPLINE_EXPORT double natural_logarithm(double x) noexcept;

}}}  // namespace orispline::elementary

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
