// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/curve/curve.hpp>

namespace orispline::fuzz {

/// How large the terms get of which rounding takes its share: on a segment of length h [s] that turns by A [rad], where
/// A is the largest of |ω|h, (|α|h²)^½ and (|jerk|h³)^⅓, a derivative of order k sums terms up to (1 + A)^k/hᵏ. The one
/// stands for the rounding of the orientation itself. Angles of A radians are rounded too, and turn all of them along:
/// once more a factor of 1 + A.
struct SegmentScale {
  double length = 1.0;  ///< h [s]
  double turn = 0.0;    ///< A [rad]

  [[nodiscard]] double of_order(int order) const { return (1.0 + turn) * std::pow((1.0 + turn) / length, order); }
};

[[nodiscard]] inline SegmentScale scale_of(const AnyCurve& curve, std::size_t segment) {
  const KnotSpan span = curve.knots().span(segment);
  SegmentScale scale{.length = span.step()};
  constexpr int samples = 8;
  for (int k = 0; k <= samples; ++k) {
    const double t = k == samples ? span.end() : span.start() + span.step() * k / samples;
    const Motion m = curve.motion_on(segment, t);
    const double h = scale.length;
    scale.turn = std::max({scale.turn, m.angular_velocity.norm() * h, std::sqrt(m.angular_acceleration.norm()) * h,
                           std::cbrt(m.angular_jerk.norm()) * h});
  }
  return scale;
}

/// Rounding of an order where two segments meet: of both of them.
[[nodiscard]] inline double scale_at_knot(const SegmentScale& left, const SegmentScale& right, int order) {
  return std::max(left.of_order(order), right.of_order(order));
}

/// Orders 0 to 3 of the difference of two motions: of the quaternions, with their signs, and of the rates.
[[nodiscard]] inline std::array<double, 4> difference(const Motion& a, const Motion& b) {
  return {(a.orientation.coeffs() - b.orientation.coeffs()).norm(), (a.angular_velocity - b.angular_velocity).norm(),
          (a.angular_acceleration - b.angular_acceleration).norm(), (a.angular_jerk - b.angular_jerk).norm()};
}

[[nodiscard]] inline bool is_finite(const Motion& m) {
  return m.orientation.coeffs().allFinite() && m.angular_velocity.allFinite() && m.angular_acceleration.allFinite() &&
         m.angular_jerk.allFinite();
}

/// Some hundred operations, of which each rounds.
inline constexpr double closed_form_rounding = 8192.0 * std::numeric_limits<double>::epsilon();

}  // namespace orispline::fuzz
