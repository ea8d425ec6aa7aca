// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

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

/// A piece of time [s].
struct Piece {
  double start, end;

  [[nodiscard]] double middle() const noexcept { return 0.5 * (start + end); }
};

/// ∫ f dt over each piece by the Gauss rule; f(times, values) writes its Figures<N> at all nodes together.
template <int N, std::size_t Pieces, class F>
[[nodiscard]] std::array<Figures<N>, Pieces> gauss_integrals(F& f, const std::array<Piece, Pieces>& pieces) {
  std::array<TimeRule, Pieces> rules;
  std::array<double, Pieces * gauss_nodes> times;
  for (std::size_t k = 0; k < Pieces; ++k) {
    rules[k] = time_rule(pieces[k].start, pieces[k].end);
    std::ranges::copy(rules[k].times, times.begin() + k * gauss_nodes);
  }
  std::array<Figures<N>, Pieces * gauss_nodes> values;
  f(std::span<const double>(times), std::span<Figures<N>>(values));
  std::array<Figures<N>, Pieces> sums;
  for (std::size_t k = 0; k < Pieces; ++k) {
    sums[k].setZero();
    for (std::size_t i = 0; i < gauss_nodes; ++i) sums[k] += rules[k].weights[i] * values[k * gauss_nodes + i];
    sums[k] *= pieces[k].end - pieces[k].start;
  }
  return sums;
}

/// Relative to the integral over the piece from a to b: 1e-10, or what the rounding of times leaves undecided.
[[nodiscard]] double quadrature_tolerance(double a, double b) noexcept;
/// Then a piece is left as it is, and where times are too coarse for its halves.
inline constexpr int most_halvings = 10;

/// The integral over a piece from those over its halves, which are halved in turn until they agree with `whole`, the
/// rule over both, within `allowed`.
template <int N, class F>
[[nodiscard]] Figures<N> halved_integral(F& f, const Piece& piece, const Figures<N>& whole, const Figures<N>& left,
                                         const Figures<N>& right, const Figures<N>& allowed, int halvings) {
  Figures<N> sum = left + right;
  const double middle = piece.middle();
  if (halvings <= 1 || !((sum - whole).abs() > allowed).any() || !can_be_halved(piece.start, middle)) return sum;
  const Piece first{piece.start, middle}, second{middle, piece.end};
  const auto quarters =
      gauss_integrals<N, 4>(f, {Piece{first.start, first.middle()}, Piece{first.middle(), first.end},
                                Piece{second.start, second.middle()}, Piece{second.middle(), second.end}});
  const Figures<N> half = 0.5 * allowed;
  return halved_integral<N>(f, first, left, quarters[0], quarters[1], half, halvings - 1) +
         halved_integral<N>(f, second, right, quarters[2], quarters[3], half, halvings - 1);
}

/// ∫ f dt over a piece on which f is smooth, to quadrature_tolerance() relative to the piece's own integral or, where
/// that is more, to `rounding`: adaptive. f(times, values) writes Figures<N> at up to 40 times together.
template <int N, class F>
[[nodiscard]] Figures<N> adaptive_integral(F&& f, double a, double b, const Figures<N>& rounding) {
  const Piece piece{a, b};
  if (!can_be_halved(a, b)) return gauss_integrals<N, 1>(f, {piece})[0];
  const auto found = gauss_integrals<N, 3>(f, {piece, Piece{a, piece.middle()}, Piece{piece.middle(), b}});
  const Figures<N> allowed = (quadrature_tolerance(a, b) * found[0].abs()).max(rounding);
  return halved_integral<N>(f, piece, found[0], found[1], found[2], allowed, most_halvings);
}

}}  // namespace orispline
