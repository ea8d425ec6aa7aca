// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/beta_polygon.hpp>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Expected<BetaShape> beta_shape(std::string_view method, const std::vector<double>& beta1,
                               const std::vector<double>& beta2) {
  for (std::size_t i = 0; i < beta1.size(); ++i) {
    const double b1 = beta1[i], b2 = beta2[i], pole = -2.0 * b1 * (1.0 + b1);
    if (!(b2 > pole))
      return failure(ErrorCode::bad_argument,
                     formatted("{}: beta2 is {}, wanted more than -2 beta1 (1 + beta1) = {}: there the control "
                               "points of the construction meet a pole or fold back",
                               method, b2, pole),
                     {.key = i});
  }
  return beta_shape_over(beta1, beta2);
}

ControlPolygon<Eigen::Quaterniond> beta_polygon(std::span<const Eigen::Quaterniond> points, const BetaShape& shape) {
  ControlPolygon<Eigen::Quaterniond> polygon;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const BetaSegment<double> segment = beta_segment<double>(points, shape, i);
    polygon.bases.push_back(segment.base);
    polygon.increments.insert(polygon.increments.end(), segment.increments.begin(), segment.increments.end());
  }
  return polygon;
}

ControlPolygon<Eigen::Vector3d> beta_polygon(std::span<const Eigen::Vector3d> points, const BetaShape& shape) {
  std::vector<Eigen::Vector3d> controls;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    controls.push_back(shape.joint_at(i, points[i - 1], points[i], points[i + 1]));
    if (i + 2 == points.size()) break;
    controls.push_back(on_geodesic(points[i], points[i + 1], shape.inner1[i]));
    controls.push_back(on_geodesic(points[i], points[i + 1], shape.inner2[i]));
  }
  return polygon_through<Eigen::Vector3d>(controls, 3, 3);
}

}}  // namespace orispline
