// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/math/number.hpp>

// Entire functions of the squared angle, smooth through zero: what exp, log and the Jacobians are made of.
// Each takes x = θ². Below its threshold a Taylor polynomial in x is used, above it the closed form; the thresholds are
// where the closed form has lost less than four bits and the polynomial still has all of them.

namespace orispline::series {

template <Number T, std::size_t N>
[[nodiscard]] T horner(const std::array<double, N>& coefficients, const T& x) noexcept {
  T sum(coefficients[N - 1]);
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + T(coefficients[k]);
  return sum;
}

/// 1/(2k + offset)! with alternating signs, k = 0…N-1.
template <std::size_t N>
[[nodiscard]] consteval std::array<double, N> alternating_factorials(int offset) {
  std::array<double, N> c{};
  double factorial = 1.0;  // exact: at most 22! is formed below 2^70, rounded once per product beyond 18!
  int n = 0;
  for (std::size_t k = 0; k < N; ++k) {
    for (; n < 2 * static_cast<int>(k) + offset; ++n) factorial *= n + 1;
    c[k] = (k % 2 == 0 ? 1.0 : -1.0) / factorial;
  }
  return c;
}

/// cos θ as a function of x = θ².
template <Number T>
[[nodiscard]] T cos_sqrt(const T& x) noexcept {
  if (value_of(x) < 1.0) return horner(alternating_factorials<10>(0), x);
  T sine, cosine;
  sin_cos(sqrt_of(x), sine, cosine);
  return cosine;
}

/// sin θ / θ as a function of x = θ².
template <Number T>
[[nodiscard]] T sinc_sqrt(const T& x) noexcept {
  if (value_of(x) < 1.0) return horner(alternating_factorials<10>(1), x);
  const T theta = sqrt_of(x);
  T sine, cosine;
  sin_cos(theta, sine, cosine);
  return sine / theta;
}

/// (1 - cos θ)/θ² as a function of x = θ², without cancellation: ½ sinc²(θ/2).
template <Number T>
[[nodiscard]] T versine_ratio(const T& x) noexcept {
  const T s = sinc_sqrt<T>(x * T(0.25));
  return s * s * T(0.5);
}

/// (θ - sin θ)/θ³ as a function of x = θ².
template <Number T>
[[nodiscard]] T sine_defect_ratio(const T& x) noexcept {
  if (value_of(x) < 1.0) return horner(alternating_factorials<9>(3), x);
  return (T(1.0) - sinc_sqrt<T>(x)) / x;
}

/// (1 - (θ/2) cot(θ/2))/θ² as a function of x = θ² < (2π)²; infinite at θ = 2π.
template <Number T>
[[nodiscard]] T cotangent_defect_ratio(const T& x) noexcept {
  // |B_{2k+2}|/(2k+2)!, the Taylor coefficients in x.
  constexpr std::array<double, 11> c{1.0 / 12,
                                     1.0 / 720,
                                     1.0 / 30240,
                                     1.0 / 1209600,
                                     1.0 / 47900160,
                                     691.0 / 1307674368000.0,
                                     1.0 / 74724249600.0,
                                     3617.0 / 10670622842880000.0,
                                     43867.0 / 5109094217170944000.0,
                                     174611.0 / 802857662698291200000.0,
                                     77683.0 / 14101100039391805440000.0};
  if (value_of(x) < 1.0) return horner(c, x);
  const T half = sqrt_of(x) * T(0.5);
  T sine, cosine;
  sin_cos(half, sine, cosine);
  return (T(1.0) - half * cosine / sine) / x;
}

}  // namespace orispline::series
