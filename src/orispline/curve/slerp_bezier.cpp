// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/slerp_bezier.hpp>

namespace orispline {

SlerpBezierCurve::Segment slerp_bezier_segment(const std::array<Eigen::Quaterniond, 4>& controls) {
  const auto& [from, leaving, arriving, to] = controls;
  return {.starts = {from, leaving, arriving},
          .increments = {increment<double>(from, leaving), increment<double>(leaving, arriving),
                         increment<double>(arriving, to)}};
}

SlerpBezierCurve slerp_bezier_curve(Knots knots, std::span<const Eigen::Quaterniond> keys,
                                    std::span<const Eigen::Vector3d> leaving,
                                    std::span<const Eigen::Vector3d> arriving) {
  std::vector<SlerpBezierCurve::Segment> segments;
  segments.reserve(knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double third = knots.span(i).step() / 3.0;
    segments.push_back(slerp_bezier_segment({keys[i], keys[i] * exp<double>(third * leaving[i]),
                                             keys[i + 1] * exp<double>(-third * arriving[i + 1]), keys[i + 1]}));
  }
  return {std::move(knots), std::move(segments)};
}

}  // namespace orispline
