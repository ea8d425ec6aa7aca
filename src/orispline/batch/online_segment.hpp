// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/recent_keys.hpp>

namespace orispline {

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

  [[nodiscard]] KnotSpan span() const noexcept {
    return {std::span(times).first(knots), start, times[1] - times[0], times[knots - 1] - times[knots - 2]};
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

/// The segment from key `s` of these to the next one, four keys blended. A key that is not there is beyond an end of
/// the curve: its ghost stands in. Errors: those of the ghosts.
template <CumulativeBasis B>
requires(B::increments == 3)
    [[nodiscard]] Expected<OnlineSegment<B>> four_key_segment(const B& basis, const RecentKeys& keys, std::size_t s,
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
  return segment;
}

}  // namespace orispline
