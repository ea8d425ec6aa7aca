// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/pose_curve.hpp>
#include <orispline/math/bernstein.hpp>
#include <orispline/online/recent_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A basis on one knot span, its polynomials formed once.
template <std::size_t M>
struct SpanBlending {
  static constexpr std::size_t increments = 3, stride = 1;
  static constexpr int degree = static_cast<int>(M) - 1;
  BernsteinRows<3, M> coefficients{};

  template <Number T>
  [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
    return bernstein_sums(coefficients, span.normalised(t));
  }
};

/// What the span's blending functions are computed from at any time: their polynomials, or the basis itself.
template <class B>
[[nodiscard]] auto blending_on([[maybe_unused]] KnotSpan span, const B& basis) noexcept {
  if constexpr (requires { basis.coefficients(span); })
    return SpanBlending<std::tuple_size_v<typename decltype(basis.coefficients(span))::value_type>>{
        basis.coefficients(span)};
  else return basis;
}

/// A segment of a cumulative curve that holds all that it depends on: evaluated by the formulas of the whole curve, it
/// gives the same bits.
template <CumulativeBasis B>
struct OnlineSegment {
  std::array<double, RecentKeys::most> times{};  ///< its knots and their neighbours [s]
  std::size_t knots = 0;                         ///< how many of these there are
  std::size_t start = 0;                         ///< its first knot among them
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();
  std::array<Eigen::Vector3d, B::increments> increments{};
  std::array<Eigen::Vector3d, B::increments + 1> points{};
  decltype(blending_on(KnotSpan{}, std::declval<const B&>())) blending{};

  [[nodiscard]] KnotSpan span() const noexcept {
    return {std::span(times).first(knots), start, times[1] - times[0], times[knots - 1] - times[knots - 2]};
  }

  /// From each of the positions to the next.
  [[nodiscard]] std::array<Eigen::Vector3d, B::increments> displacements() const noexcept {
    std::array<Eigen::Vector3d, B::increments> all;
    for (std::size_t k = 0; k < B::increments; ++k) all[k] = points[k + 1] - points[k];
    return all;
  }

  /// The same as segment `start` of a curve that has nothing else.
  [[nodiscard]] PoseCurve curve(const B& basis) const {
    const Knots all({times.begin(), times.begin() + static_cast<std::ptrdiff_t>(knots)});
    return {.orientation = CumulativeCurve<B>(all, basis, polygon<Eigen::Quaterniond>(base, increments)),
            .position = CumulativePath<B>(all, basis, polygon<Eigen::Vector3d>(points[0], displacements()))};
  }

  /// Becomes, in place, the segment between the inner two of four keys.
  void blend(const B& basis, const RecentKeys& four_keys) noexcept {
    static_assert(B::increments == RecentKeys::most - 1);
    times = four_keys.times;
    knots = RecentKeys::most;
    start = 1;
    base = four_keys.orientations[0];
    increments = four_keys.increments;
    points = four_keys.positions;
    blending = blending_on(span(), basis);
  }

 private:
  /// That has these increments on the segment.
  template <CurvePoint P>
  [[nodiscard]] ControlPolygon<P> polygon(const P& first, const std::array<Displacement<P>, B::increments>& own) const {
    ControlPolygon<P> whole{
        .bases = std::vector<P>(knots - 1, first),
        .increments = std::vector<Displacement<P>>((knots - 2) * B::stride + B::increments, Displacement<P>::Zero())};
    std::ranges::copy(own, whole.increments.begin() + static_cast<std::ptrdiff_t>(start * B::stride));
    return whole;
  }
};

/// The segment from key `s` of these to the next one, two keys blended: slerp.
template <CumulativeBasis B>
requires(B::increments == 1) [[nodiscard]] OnlineSegment<B> two_key_segment(const RecentKeys& keys, std::size_t s) {
  return {.times = {keys.times[s], keys.times[s + 1]},
          .knots = 2,
          .base = keys.orientations[s],
          .increments = {keys.increments[s]},
          .points = {keys.positions[s], keys.positions[s + 1]}};
}

/// The segment from key `s` of these to the next one at an end of the curve, four keys blended. The ghosts of the ends
/// stand in for the keys that are not there. Errors: those of the ghosts.
template <CumulativeBasis B>
requires(B::increments == 3)
    [[nodiscard]] Expected<OnlineSegment<B>> end_segment(const B& basis, const RecentKeys& keys, std::size_t s,
                                                         const End& curve_start, const End& curve_end) {
  const bool has_before = s > 0, has_after = s + 2 < keys.size;
  const std::size_t first = has_before ? s - 1 : s, last = has_after ? s + 2 : s + 1;
  OnlineSegment<B> segment{.knots = last - first + 1, .start = s - first};
  for (std::size_t k = first; k <= last; ++k) segment.times[k - first] = keys.times[k];
  segment.increments[1] = keys.increments[s];
  segment.points[1] = keys.positions[s];
  segment.points[2] = keys.positions[s + 1];
  if (has_before) {
    segment.base = keys.orientations[s - 1];
    segment.increments[0] = keys.increments[s - 1];
    segment.points[0] = keys.positions[s - 1];
  } else {
    const auto ghost = ghost_beyond(EndKey::first, keys, curve_start, start_weights(basis, segment.span()));
    if (!ghost) return tl::unexpected(ghost.error());
    segment.base = keys.orientations[s] * exp<double>(-ghost->turn);
    segment.increments[0] = ghost->turn;
    segment.points[0] = keys.positions[s] - ghost->shift;
  }
  if (has_after) {
    segment.increments[2] = keys.increments[s + 1];
    segment.points[3] = keys.positions[s + 2];
  } else {
    const auto ghost = ghost_beyond(EndKey::last, keys, curve_end, end_weights(basis, segment.span()).mirrored());
    if (!ghost) return tl::unexpected(ghost.error());
    segment.increments[2] = -ghost->turn;
    segment.points[3] = keys.positions[s + 1] - ghost->shift;
  }
  segment.blending = blending_on(segment.span(), basis);
  return segment;
}

}}  // namespace orispline
