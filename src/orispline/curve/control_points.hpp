// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// End rules of the local four-key families; the first is the default.
inline constexpr std::array four_key_ends_repeat{EndRule::repeat, EndRule::natural, EndRule::quadratic,
                                                 EndRule::cubic,  EndRule::clamped, EndRule::rest};
inline constexpr std::array four_key_ends_natural{EndRule::natural, EndRule::repeat,  EndRule::quadratic,
                                                  EndRule::cubic,   EndRule::clamped, EndRule::rest};

/// How the increments before and after a knot make up its rate: ω = before · a + after · b [1/s].
struct RateWeights {
  double before, after;
  /// Seen backwards in time.
  [[nodiscard]] RateWeights mirrored() const noexcept { return {.before = after, .after = before}; }
};

/// A clamped end, whose given rate is angular, continues naturally in space.
[[nodiscard]] inline EndRule rule_for_positions(EndRule rule) noexcept {
  return rule == EndRule::clamped ? EndRule::natural : rule;
}

/// The neighbourhood of an end key, looked at inwards from it: the same for orientations and positions, start and end.
struct EndNeighbourhood {
  std::function<double(std::size_t)> distance;               ///< time from the end key to the j-th inward key [s], > 0
  std::function<Eigen::Vector3d(std::size_t)> displacement;  ///< increment from the end key to the j-th inward key
};

/// The increment a from the ghost key to the end key, so that ghost · exp(a) = end key; the ghost's distance in time
/// mirrors that of the first inward key.
///
/// `inward_rate` is the prescribed rate for clamped and rest ends. Errors (bad_argument): a clamped end whose tension
/// is zero, for then no ghost can give it a rate. Source: docs/conventions.md.
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Vector3d> ghost_increment(EndRule rule,
                                                                         const Eigen::Vector3d& inward_rate,
                                                                         RateWeights weights,
                                                                         const EndNeighbourhood& end);

/// The four-key polygon with a ghost beyond either end: segment i starts from key i-1, n keys give n+1 increments.
template <CurvePoint P>
[[nodiscard]] ORISPLINE_EXPORT Expected<ControlPolygon<P>> ghosted_polygon(const Keyframes& keys,
                                                                           const FamilySettings& settings,
                                                                           RateWeights at_start, RateWeights at_end);

/// Weights of the first knot's rate in a four-key basis, read off the basis itself.
template <CumulativeBasis B>
[[nodiscard]] RateWeights start_weights(const B& basis, KnotSpan first) noexcept {
  const auto b = basis(first, Jet<double, 1>::variable(first.start()));
  return {.before = b[0].c[1], .after = b[1].c[1]};
}

/// Weights of the last knot's rate in a four-key basis.
template <CumulativeBasis B>
[[nodiscard]] RateWeights end_weights(const B& basis, KnotSpan last) noexcept {
  const auto b = basis(last, Jet<double, 1>::variable(last.end()));
  return {.before = b[1].c[1], .after = b[2].c[1]};
}

}}  // namespace orispline
