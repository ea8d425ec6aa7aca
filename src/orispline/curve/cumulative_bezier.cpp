// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/cumulative_bezier.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

CubicBezierCurve hermite_curve(Knots knots, std::span<const Eigen::Quaterniond> joints,
                               std::span<const Eigen::Vector3d> rates) {
  ControlPolygon<> polygon{.bases = {joints.begin(), joints.end() - 1}, .increments = {}};
  polygon.increments.reserve(3 * knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double third = knots.span(i).step() / 3.0;
    const Eigen::Vector3d leaving = third * rates[i], arriving = third * rates[i + 1];
    const Eigen::Quaterniond inner_start = joints[i] * exp<double>(leaving);
    const Eigen::Quaterniond inner_end = joints[i + 1] * exp<double>(-arriving);
    polygon.increments.insert(polygon.increments.end(), {leaving, increment<double>(inner_start, inner_end), arriving});
  }
  return {std::move(knots), CubicBezierBasis{}, std::move(polygon)};
}

}}  // namespace orispline
