// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <orispline/curve/chart_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One of the pieces that a segment is cut into.
template <std::size_t Degree>
struct RefinedPiece {
  double start, end;  ///< shares of the segment, from 0 to 1
  ChartPiece<Degree> chart;
};

/// A curve whose segments are cut into pieces, each one exponential of a vector polynomial.
///
/// The cuts are shares of a segment, not times: an epoch rounds them no more than it rounds the knots.
template <std::size_t Degree>
class RefinedChartCurve {
 public:
  using Piece = RefinedPiece<Degree>;

  /// `pieces`: those of the first segment, of the second, and so on, each from 0 to 1.
  RefinedChartCurve(Knots knots, std::vector<Piece> pieces) : knots_(std::move(knots)), pieces_(std::move(pieces)) {
    first_.reserve(knots_.segments() + 1);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (pieces_[i].start == 0.0) first_.push_back(i);
    ORISPLINE_EXPECT(first_.size() == knots_.segments());
    first_.push_back(pieces_.size());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    const T u = knots_.span(segment).normalised(t);
    const Piece& piece = piece_at(value_of(u), segment);
    return constant<T>(piece.chart.base) * exp<T>(rotation_vector(piece.chart, within(piece, u)));
  }

  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    const auto u = knots_.span(segment).normalised(Jet<double, 3>::variable(t));
    const Piece& piece = piece_at(value_of(u), segment);
    return chart_motion(piece.chart.base, rotation_vector(piece.chart, within(piece, u)));
  }

 private:
  template <Number T>
  [[nodiscard]] static T within(const Piece& piece, const T& u) noexcept {
    return (u - T(piece.start)) / Plain<T>(piece.end - piece.start);
  }

  /// At a cut the piece to the right, beyond the segment its first or last piece.
  [[nodiscard]] const Piece& piece_at(double u, std::size_t segment) const noexcept {
    const auto first = pieces_.begin() + static_cast<std::ptrdiff_t>(first_[segment]);
    const auto last = pieces_.begin() + static_cast<std::ptrdiff_t>(first_[segment + 1]);
    return *(std::upper_bound(first + 1, last, u, [](double share, const Piece& p) { return share < p.start; }) - 1);
  }

  Knots knots_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_;  ///< piece of each segment; at the end their number
};

}}  // namespace orispline
