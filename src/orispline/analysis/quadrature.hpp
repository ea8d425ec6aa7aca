// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A row of N figures that are integrated at the same times.
template <int N>
using Figures = Eigen::Array<double, N, 1>;

/// Of Kronrod's rule, exact for polynomials up to degree 31. Every second one is a node of Gauss's rule of ten, exact
/// up to degree 19: from the same values comes a second integral, which tells how good the first one is.
inline constexpr std::size_t quadrature_nodes = 21;

/// Both rules on a piece of time: Σ weight f(time) is the mean of f.
struct TimeRule {
  std::array<double, quadrature_nodes> times, weights;
  std::array<double, quadrature_nodes / 2> gauss_weights;  ///< of the times 1, 3, …
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

/// An integral by both rules.
template <int N>
struct Integral {
  Figures<N> kronrod, gauss;
};

/// ∫ f dt over each piece; f(times, values) writes its Figures<N> at all nodes together.
template <int N, std::size_t Pieces, class F>
[[nodiscard]] std::array<Integral<N>, Pieces> integrals(F& f, const std::array<Piece, Pieces>& pieces) {
  const auto rules = [&]<std::size_t... K>(std::index_sequence<K...>) {
    return std::array{time_rule(pieces[K].start, pieces[K].end)...};
  }
  (std::make_index_sequence<Pieces>());
  std::array<double, Pieces * quadrature_nodes> times;
  for (std::size_t k = 0; k < Pieces; ++k) std::ranges::copy(rules[k].times, &times[k * quadrature_nodes]);
  std::array<Figures<N>, Pieces * quadrature_nodes> values;
  f(std::span<const double>(times), std::span<Figures<N>>(values));
  std::array<Integral<N>, Pieces> sums;
  for (std::size_t k = 0; k < Pieces; ++k) {
    const auto* const here = &values[k * quadrature_nodes];
    auto& [kronrod, gauss] = sums[k];
    kronrod.setZero();
    gauss.setZero();
    for (std::size_t i = 0; i < quadrature_nodes; ++i) kronrod += rules[k].weights[i] * here[i];
    for (std::size_t i = 0; i < quadrature_nodes / 2; ++i) gauss += rules[k].gauss_weights[i] * here[2 * i + 1];
    kronrod *= pieces[k].end - pieces[k].start;
    gauss *= pieces[k].end - pieces[k].start;
  }
  return sums;
}

/// Relative to the integral over the piece from a to b: 1e-10, or what the rounding of times leaves undecided.
[[nodiscard]] double quadrature_tolerance(double a, double b) noexcept;
/// So often a piece is halved whatever comes of it; then only as long as the rules come nearer to each other by half.
/// So what is rounding is not looked into, and a corner of f is found, where a halving quarters what they differ by.
inline constexpr int most_halvings = 10;

/// The integral over a piece, which is halved in turn until both rules agree within `allowed`.
template <int N, class F>
[[nodiscard]] Figures<N> halved_integral(F& f, const Piece& piece, const Integral<N>& found, const Figures<N>& allowed,
                                         int halvings) {
  const Figures<N> differs = (found.kronrod - found.gauss).abs();
  if (!(differs > allowed).any() || !can_be_halved(piece.start, piece.end)) return found.kronrod;
  const Piece first{piece.start, piece.middle()}, second{piece.middle(), piece.end};
  const auto halves = integrals<N, 2>(f, {first, second});
  const Figures<N> half = 0.5 * allowed;
  const Figures<N> differ = (halves[0].kronrod - halves[0].gauss).abs() + (halves[1].kronrod - halves[1].gauss).abs();
  if (halvings <= 0 && (differ > (0.5 * differs).max(allowed)).any()) return halves[0].kronrod + halves[1].kronrod;
  return halved_integral<N>(f, first, halves[0], half, halvings - 1) +
         halved_integral<N>(f, second, halves[1], half, halvings - 1);
}

/// ∫ f dt over a piece on which f is smooth, to quadrature_tolerance() relative to the piece's own integral or, where
/// that is more, to `rounding`: adaptive. f(times, values) writes Figures<N> at up to 42 times together.
template <int N, class F>
[[nodiscard]] Figures<N> adaptive_integral(F&& f, double a, double b, const Figures<N>& rounding) {
  const Piece piece{a, b};
  const Integral<N> found = integrals<N, 1>(f, {piece})[0];
  const Figures<N> allowed = (quadrature_tolerance(a, b) * found.kronrod.abs()).max(rounding);
  return halved_integral<N>(f, piece, found, allowed, most_halvings);
}

}}  // namespace orispline
