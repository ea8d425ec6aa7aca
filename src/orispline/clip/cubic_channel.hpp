// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A channel that follows a curve, and how far it is from it at most.
template <CurvePoint P>
struct CubicChannel {
  Channel<P> channel{};
  double largest_distance = 0.0;  ///< [rad], or in the unit of positions
  double largest_at = 0.0;        ///< [s]
};

/// The curve as `cubicspline`: keys at its knots and, where that is not enough, at the middles of intervals that are
/// halved until the channel is within the tolerance [rad] everywhere and turns by less than 179° from key to key. The
/// tangents are the curve's own, on either side of a key: dq/dt = ½ q ω.
///
/// An interval is looked at in 15 places, and beside the farthest of these until nothing rises. One that is shorter
/// than 2⁻²⁰ of the curve is halved no more: where the curve jumps, as steps do, the channel goes from one value to the
/// other in so short a time, and the largest distance is nearly what it jumps by. Precondition: the tolerance is
/// greater than 0.
[[nodiscard]] ORISPLINE_EXPORT CubicChannel<Eigen::Quaterniond> cubic_channel(const AnyCurve& curve, double tolerance);
/// The path of positions as `cubicspline`, found in the same way, within the tolerance [their unit].
[[nodiscard]] ORISPLINE_EXPORT CubicChannel<Eigen::Vector3d> cubic_channel(const AnyPath& path, double tolerance);

/// The farthest that a channel is from a curve between the first and the last key of it, looked for in the same way
/// [rad, or the unit of positions].
[[nodiscard]] ORISPLINE_EXPORT double largest_distance(const AnyCurve& curve, const RotationChannel& channel);
[[nodiscard]] ORISPLINE_EXPORT double largest_distance(const AnyPath& path, const VectorChannel& channel);

}}  // namespace orispline
