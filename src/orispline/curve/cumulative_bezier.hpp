// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Cumulative cubic Bernstein polynomials: segment i runs through control orientations 3i … 3i+3.
///
/// At u = 0 the rate is 3 φ_1/h, at u = 1 it is 3 φ_3/h. Source: Kim, Kim & Shin 1995; 001, (4).
struct CubicBezierBasis {
  static constexpr std::size_t increments = 3, stride = 3;
  static constexpr int degree = 3;
  template <Number T>
  [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
    return at<T>(span.normalised(t));
  }
  /// At u in [0, 1] of a segment.
  template <Number T>
  [[nodiscard]] static std::array<T, 3> at(const T& u) noexcept {
    const T v = T(1.0) - u;
    return {T(1.0) - v * v * v, u * u * (T(3.0) - T(2.0) * u), u * u * u};
  }
};

using CubicBezierCurve = CumulativeCurve<CubicBezierBasis>;
using CubicBezierPath = CumulativePath<CubicBezierBasis>;

/// Composite cubic from the joints' orientations and the rate at either end of every segment [rad/s].
///
/// Segment i goes from joint i with leaving rate to joint i+1 with arriving rate; exact at both ends.
[[nodiscard]] CubicBezierCurve hermite_curve(Knots knots, std::span<const Eigen::Quaterniond> joints,
                                             std::span<const Eigen::Vector3d> rates);

}}  // namespace orispline
