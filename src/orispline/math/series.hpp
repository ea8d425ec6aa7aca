// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <orispline/math/jet.hpp>

// Functions that are smooth through zero angle: what exp, log and the Jacobians are made of.
// All but the last take x = θ². Below its threshold a Taylor polynomial in x is used, above it the closed form. The
// polynomials are long enough for three derivatives in x, which jets take; the closed forms have lost less than four
// bits at the threshold.

namespace orispline { inline namespace ORISPLINE_ABI { namespace series {

template <Number T, std::size_t N>
[[nodiscard]] T horner(const std::array<double, N>& coefficients, const T& x) noexcept {
  T sum = T(coefficients[N - 1]);
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * x + T(coefficients[k]);
  return sum;
}

/// The Taylor coefficients at x of a polynomial, from those of the polynomial without its lowest coefficient.
template <class T, std::size_t... M>
constexpr void horner_step(std::array<T, sizeof...(M) + 1>& taylor, const T& x, const T& lowest,
                           std::index_sequence<M...>) noexcept {
  constexpr std::size_t last = sizeof...(M);
  ((taylor[last - M] = taylor[last - M] * x + taylor[last - M - 1]), ...);
  taylor[0] = taylor[0] * x + lowest;
}

/// A polynomial of a power series, by way of the polynomial's own Taylor series at the value of x: a third of the
/// products of power series.
template <class T, int K, std::size_t N>
[[nodiscard]] Jet<T, K> horner(const std::array<double, N>& coefficients, const Jet<T, K>& x) noexcept {
  constexpr std::size_t orders = Jet<T, K>::size;
  std::array<T, orders> taylor{};
  for (std::size_t k = N; k-- > 0;)
    horner_step(taylor, x.c[0], T(coefficients[k]), std::make_index_sequence<orders - 1>{});
  Jet<T, K> sum(taylor[orders - 1]), moved = x;
  moved.c[0] = T(0.0);
  for (std::size_t m = orders - 1; m-- > 0;) sum = sum * moved + Jet<T, K>(taylor[m]);
  return sum;
}

/// Over duals: once for all directions.
template <std::size_t K, std::size_t N>
[[nodiscard]] Dual<K> horner(const std::array<double, N>& coefficients, const Dual<K>& x) noexcept {
  return Dual<K>::chained(horner(coefficients, Jet<double, 1>::variable(x.value)), x);
}

/// 1/(2k + offset)! with alternating signs, k = 0…N-1.
template <std::size_t N>
[[nodiscard]] consteval std::array<double, N> alternating_factorials(int offset) {
  std::array<double, N> c{};
  double factorial = 1.0;  // exact to 22!, the first that a coefficient of any weight needs
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
  if (value_of(x) < 4) return horner(alternating_factorials<16>(0), x);
  T sine, cosine;
  sin_cos(sqrt_of(x), sine, cosine);
  return cosine;
}

/// sin θ / θ as a function of x = θ².
template <Number T>
[[nodiscard]] T sinc_sqrt(const T& x) noexcept {
  if (value_of(x) < 4) return horner(alternating_factorials<16>(1), x);
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
  if (value_of(x) < 4) return horner(alternating_factorials<16>(3), x);
  return (T(1.0) - sinc_sqrt<T>(x)) / x;
}

/// (1 - (θ/2) cot(θ/2))/θ² as a function of x = θ² < (2π)²; infinite at θ = 2π.
template <Number T>
[[nodiscard]] T cotangent_defect_ratio(const T& x) noexcept {
  // |B_{2k+2}|/(2k+2)!, the Taylor coefficients in x; they fall like (2π)^-2k.
  constexpr std::array<double, 15> c{0.083333333333333333333,   0.0013888888888888888889,  0.000033068783068783068783,
                                     8.2671957671957671958e-7,  2.0876756987868098979e-8,  5.2841901386874931848e-10,
                                     1.3382536530684678833e-11, 3.3896802963225828668e-13, 8.5860620562778445641e-15,
                                     2.174868698558061873e-16,  5.5090028283602295152e-18, 1.3954464685812523341e-19,
                                     3.5347070396294674717e-21, 8.9535174270375468504e-23, 2.2679524523376830603e-24};
  if (value_of(x) < 1) return horner(c, x);
  const T half = sqrt_of(x) * T(0.5);
  T sine, cosine;
  sin_cos(half, sine, cosine);
  return (T(1.0) - half * cosine / sine) / x;
}

/// θ/sin θ as a function of y = 1 - cos θ < 0.25, smooth through θ = 0.
///
/// The series c_k = c_{k-1} k/(2k+1), whose terms fall like (y/2)^k.
template <Number T>
[[nodiscard]] T angle_over_sine(const T& y) noexcept {
  T sum(1.0);
  for (int k = 19; k >= 1; --k) sum = T(1.0) + sum * y * Plain<T>(k / (2.0 * k + 1.0));
  return sum;
}
template <std::size_t K>
[[nodiscard]] Dual<K> angle_over_sine(const Dual<K>& y) noexcept {
  return Dual<K>::chained(angle_over_sine(Jet<double, 1>::variable(y.value)), y);
}

}}}  // namespace orispline::series
