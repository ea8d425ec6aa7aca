// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include <orispline/curve/knots.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
  /// From the control orientations: a segment's last one is the next one's first.
  SlerpBezierCurve(Knots knots, std::span<const Eigen::Quaterniond> controls);

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    const T u = knots_.span(segment).normalised(t);
    const Segment& s = segments_[segment];
    return slerp_cubic<T>({constant<T>(s.starts[0]), constant<T>(s.starts[1]), constant<T>(s.starts[2])},
                          {constant<T>(s.increments[0]), constant<T>(s.increments[1]), constant<T>(s.increments[2])},
                          u);
  }

 private:
  struct Segment {  // the three arcs of the control polygon: where each begins and its increment [rad]
    std::array<Eigen::Quaterniond, 3> starts;
    std::array<Eigen::Vector3d, 3> increments;
  };
  Knots knots_;
  std::vector<Segment> segments_;
};

}}  // namespace orispline
