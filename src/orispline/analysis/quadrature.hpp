// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <Eigen/Core>

#include <orispline/math/gauss_legendre.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A row of N figures that are integrated at the same times.
template <int N>
using Figures = Eigen::Array<double, N, 1>;

/// Of the rule, exact for polynomials up to degree 19.
inline constexpr std::size_t gauss_nodes = 10;

/// The Gauss rule on a piece of time: Σ weight f(time) is the mean of f.
struct TimeRule {
  std::array<double, gauss_nodes> times, weights;
};

/// From a to b [s]. At times of today a node is rounded by a ten millionth of a second, which would move the sum more
/// than the quadrature errs: the weights are those of the rounded nodes, by the polynomial through the values there.
[[nodiscard]] TimeRule time_rule(double a, double b) noexcept;

/// Whether the halves of a piece are long enough for the nodes of the rule to be times of their own.
[[nodiscard]] bool can_be_halved(double a, double b) noexcept;

/// ∫ f dt from a to b by the Gauss rule; f(t) gives Figures<N>.
template <int N, class F>
[[nodiscard]] Figures<N> gauss_integral(const F& f, double a, double b) {
  const TimeRule rule = time_rule(a, b);
  Figures<N> sum = Figures<N>::Zero();
  for (std::size_t i = 0; i < gauss_nodes; ++i) sum += rule.weights[i] * f(rule.times[i]);
  return (b - a) * sum;
}

/// Relative to the integral over the piece from a to b: 1e-10, or what the rounding of times leaves undecided.
[[nodiscard]] double quadrature_tolerance(double a, double b) noexcept;
/// Then a piece is left as it is, and where times are too coarse for its halves.
inline constexpr int most_halvings = 10;

/// The integrals over both halves of an interval, which are halved in turn until they agree with `whole`, the rule over
/// both, within `allowed`.
template <int N, class F>
[[nodiscard]] Figures<N> halved_integral(const F& f, double a, double b, const Figures<N>& whole,
                                         const Figures<N>& allowed, int halvings) {
  const double middle = 0.5 * (a + b);
  const Figures<N> left = gauss_integral<N>(f, a, middle), right = gauss_integral<N>(f, middle, b);
  const Figures<N> sum = left + right;
  if (halvings <= 1 || !((sum - whole).abs() > allowed).any() || !can_be_halved(a, middle)) return sum;
  return halved_integral<N>(f, a, middle, left, 0.5 * allowed, halvings - 1) +
         halved_integral<N>(f, middle, b, right, 0.5 * allowed, halvings - 1);
}

/// ∫ f dt over a piece on which f is smooth, to quadrature_tolerance() relative to the piece's own integral or, where
/// that is more, to `rounding`: adaptive.
template <int N, class F>
[[nodiscard]] Figures<N> adaptive_integral(const F& f, double a, double b, const Figures<N>& rounding) {
  const Figures<N> whole = gauss_integral<N>(f, a, b);
  if (!can_be_halved(a, b)) return whole;
  const Figures<N> allowed = (quadrature_tolerance(a, b) * whole.abs()).max(rounding);
  return halved_integral<N>(f, a, b, whole, allowed, most_halvings);
}

}}  // namespace orispline
