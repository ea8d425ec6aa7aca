// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/curve/knots.hpp>
#include <orispline/math/slerp.hpp>

namespace orispline {

/// The cubic at u by de Casteljau's algorithm with slerps, from the three arcs of its control polygon.
template <Number T>
[[nodiscard]] Quaternion<T> slerp_cubic(const std::array<Quaternion<T>, 3>& starts,
                                        const std::array<Vector3<T>, 3>& increments, const T& u) noexcept {
  const auto arc = [&](std::size_t k) -> Quaternion<T> { return starts[k] * exp<T>(increments[k] * u); };
  const Quaternion<T> first = arc(0), middle = arc(1), last = arc(2);
  return slerp<T>(slerp<T>(first, middle, u), slerp<T>(middle, last, u), u);
}

/// Composite cubic by de Casteljau's algorithm with slerps: segment i has its own four control orientations.
///
/// Symmetric in time and bi-invariant, not cumulative: rates come from jets. At u = 0 the rate is 3 log(c₀⁻¹c₁)/h.
class SlerpBezierCurve {
 public:
  /// The three arcs of the control polygon: where each begins and its increment [rad].
  struct Segment {
    std::array<Eigen::Quaterniond, 3> starts;
    std::array<Eigen::Vector3d, 3> increments;
  };

  SlerpBezierCurve(Knots knots, std::vector<Segment> segments)
      : knots_(std::move(knots)), segments_(std::move(segments)) {
    ORISPLINE_EXPECT(segments_.size() == knots_.segments());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> orientation(const T& t, std::size_t segment) const noexcept {
    const T u = knots_.span(segment).normalised(t);
    const Segment& s = segments_[segment];
    return slerp_cubic<T>({constant<T>(s.starts[0]), constant<T>(s.starts[1]), constant<T>(s.starts[2])},
                          {constant<T>(s.increments[0]), constant<T>(s.increments[1]), constant<T>(s.increments[2])},
                          u);
  }

 private:
  Knots knots_;
  std::vector<Segment> segments_;
};

/// The segment from one key over the inner control orientations to the other.
[[nodiscard]] SlerpBezierCurve::Segment slerp_bezier_segment(const std::array<Eigen::Quaterniond, 4>& controls);

/// The composite cubic through keys with the rate on leaving and on arriving at each key [rad/s], body frame.
[[nodiscard]] SlerpBezierCurve slerp_bezier_curve(Knots knots, std::span<const Eigen::Quaterniond> keys,
                                                  std::span<const Eigen::Vector3d> leaving,
                                                  std::span<const Eigen::Vector3d> arriving);

}  // namespace orispline
