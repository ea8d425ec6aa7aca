// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <orispline/math/gauss_legendre.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// A row of N figures that are integrated at the same times.
template <int N>
using Figures = Eigen::Array<double, N, 1>;

/// ∫ f dt from a to b by the Gauss rule of ten points, exact for polynomials up to degree 19; f(t) gives Figures<N>.
template <int N, class F>
[[nodiscard]] Figures<N> gauss_integral(const F& f, double a, double b) {
  static const auto rule = gauss_legendre<10>();
  Figures<N> sum = Figures<N>::Zero();
  for (const auto& [u, weight] : rule) sum += weight * f(std::lerp(a, b, u));
  return (b - a) * sum;
}

/// Relative to the integral over the piece.
inline constexpr double quadrature_tolerance = 1e-10;
/// Then a piece is left as it is.
inline constexpr int most_halvings = 10;

/// The integrals over both halves of an interval, which are halved in turn until they agree with `whole`, the rule over
/// both, within `allowed`.
template <int N, class F>
[[nodiscard]] Figures<N> halved_integral(const F& f, double a, double b, const Figures<N>& whole,
                                         const Figures<N>& allowed, int halvings) {
  const double middle = 0.5 * (a + b);
  const Figures<N> left = gauss_integral<N>(f, a, middle), right = gauss_integral<N>(f, middle, b);
  const Figures<N> sum = left + right;
  if (halvings <= 1 || !((sum - whole).abs() > allowed).any()) return sum;
  return halved_integral<N>(f, a, middle, left, 0.5 * allowed, halvings - 1) +
         halved_integral<N>(f, middle, b, right, 0.5 * allowed, halvings - 1);
}

/// ∫ f dt over a piece on which f is smooth, to `quadrature_tolerance` relative to the piece's own integral or, where
/// that is more, to `rounding`: adaptive.
template <int N, class F>
[[nodiscard]] Figures<N> adaptive_integral(const F& f, double a, double b, const Figures<N>& rounding) {
  const Figures<N> whole = gauss_integral<N>(f, a, b);
  const Figures<N> allowed = (quadrature_tolerance * whole.abs()).max(rounding);
  return halved_integral<N>(f, a, b, whole, allowed, most_halvings);
}

}  // namespace orispline::inline ORISPLINE_ABI
