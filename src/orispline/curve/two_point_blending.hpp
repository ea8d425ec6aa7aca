// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/math/bernstein.hpp>
#include <orispline/math/jet.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Derivatives of orders 1…K of the two factors beside a key: φ of the increment before it, ψ of the one after it.
///
/// Near a key both neighbouring segments equal Q exp(a f) exp(b g) with f = 1 + φ₁τ + φ₂τ²/2 + …, g = ψ₁τ + …
template <std::size_t K>
struct KnotDerivatives {
  std::array<double, K> phi, psi;
};

/// Derivatives in time become derivatives in the local parameter of a segment of length h: order m times h^m.
template <std::size_t K>
[[nodiscard]] KnotDerivatives<K> scaled(KnotDerivatives<K> d, double h) noexcept {
  double power = 1.0;
  for (std::size_t m = 0; m < K; ++m) {
    power *= h;
    d.phi[m] *= power;
    d.psi[m] *= power;
  }
  return d;
}

/// Rows of Bernstein coefficients of degree 2K+1: β̃_1, β̃_2, β̃_3 of a four-key family.
template <std::size_t K>
using FourKeyBlending = BernsteinRows<3, 2 * K + 2>;

/// C(i, m) (n - m)!/n!, n = 2K+1: what the derivative of order m adds to Bernstein coefficient i, in row i, column m-1.
template <std::size_t K>
inline constexpr std::array<std::array<double, K>, K + 1> taylor_weights = [] {
  std::array<std::array<double, K>, K + 1> weights{};
  for (std::size_t i = 1; i <= K; ++i) {
    double weight = 1.0;
    for (std::size_t m = 1; m <= i; ++m)
      weights[i][m - 1] = weight *=
          static_cast<double>(i - m + 1) / (static_cast<double>(m) * static_cast<double>(2 * K + 2 - m));
  }
  return weights;
}();

/// The first K+1 Bernstein coefficients of degree 2K+1 of the polynomial with value and derivatives d at u = 0.
template <std::size_t K, class Value>
[[nodiscard]] std::array<Value, K + 1> bernstein_from_taylor(const Value& value,
                                                             const std::array<Value, K>& d) noexcept {
  std::array<Value, K + 1> c;
  c.fill(value);
  for (std::size_t i = 1; i <= K; ++i)
    for (std::size_t m = 0; m < i; ++m) c[i] += taylor_weights<K>[i][m] * d[m];
  return c;
}

/// Seen from u = 1 the coefficients run inwards: derivatives of odd order change sign.
template <std::size_t K, class Value>
[[nodiscard]] std::array<Value, K> inwards(std::array<Value, K> d) noexcept {
  for (std::size_t m = 0; m < K; m += 2) d[m] = -d[m];
  return d;
}

/// The cumulative blending functions with the given derivatives (in the local parameter) at the two ends of a segment.
///
/// The two-point Taylor (Hermite) polynomials of degree 2K+1; derivation: docs/families/uniform.md.
template <std::size_t K>
[[nodiscard]] FourKeyBlending<K> two_point_blending(const KnotDerivatives<K>& left,
                                                    const KnotDerivatives<K>& right) noexcept {
  const auto phi = bernstein_from_taylor(1.0, left.phi), psi = bernstein_from_taylor(0.0, left.psi);
  const auto phi_end = bernstein_from_taylor(1.0, inwards(right.phi));
  const auto psi_end = bernstein_from_taylor(0.0, inwards(right.psi));
  FourKeyBlending<K> b{};
  for (std::size_t i = 0; i <= K; ++i) {
    const std::size_t j = 2 * K + 1 - i;
    b[0][i] = phi[i];
    b[0][j] = 1.0;
    b[1][i] = psi[i];
    b[1][j] = phi_end[i];
    b[2][j] = psi_end[i];
  }
  return b;
}

/// The odd degree of the two-point Taylor polynomial that is every polynomial of degree Degree exactly.
template <int Degree>
inline constexpr std::size_t two_point_degree = static_cast<std::size_t>(Degree) | 1U;

/// The Bernstein coefficients of functions of time that are polynomials of degree Degree on a span, from their values
/// and derivatives at its two ends, where the local parameter is exactly 0 and 1.
template <std::size_t Count, int Degree, class Functions>
[[nodiscard]] std::array<BernsteinForm, 3> two_point_forms(KnotSpan span, const Functions& functions) noexcept {
  constexpr std::size_t n = two_point_degree<Degree>, K = (n - 1) / 2;
  using J = Jet<double, static_cast<int>(K)>;
  const auto at = [&](double t) {
    J time(t);
    if constexpr (K > 0) time.c[1] = span.step();  // derivatives in the local parameter
    return functions(span, time);
  };
  const auto start = at(span.start()), end = at(span.t[span.i + 1]);
  const auto derivatives = [](const J& value) {
    std::array<double, K> d;
    for (std::size_t m = 0; m < K; ++m) d[m] = value.derivative(m + 1);
    return d;
  };
  std::array<BernsteinForm, 3> forms{};
  for (std::size_t k = 0; k < Count; ++k) {
    const auto left = bernstein_from_taylor(start[k].c[0], derivatives(start[k]));
    const auto right = bernstein_from_taylor(end[k].c[0], inwards(derivatives(end[k])));
    for (std::size_t i = 0; i <= K; ++i) {
      forms[k].coefficients[i] = left[i];
      forms[k].coefficients[n - i] = right[i];
    }
  }
  return forms;
}

}}  // namespace orispline
