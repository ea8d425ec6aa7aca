// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a Beta curve divides the arcs between its auxiliary points. Source: He et al. 2022, section 3.1.
template <Number T>
struct BetaShapeOver {
  std::vector<T> inner1, inner2;  ///< γ_i/Δ_i and (γ_i + 1)/Δ_i, one per arc
  std::vector<T> joint;           ///< 1/(1 + β_{i,1}), one per auxiliary point

  /// Joint i, from its auxiliary point and the neighbours of that.
  template <class P>
  [[nodiscard]] P joint_at(std::size_t i, const P& before, const P& at, const P& after) const {
    return on_geodesic(on_geodesic(before, at, inner2[i - 1]), on_geodesic(at, after, inner1[i]), joint[i]);
  }
};
using BetaShape = BetaShapeOver<double>;

/// From β₁ and β₂ of every auxiliary point, which are within their ranges.
template <Number T>
[[nodiscard]] BetaShapeOver<T> beta_shape_over(const std::vector<T>& beta1, const std::vector<T>& beta2) {
  std::vector<T> gamma;
  BetaShapeOver<T> shape;
  for (std::size_t i = 0; i < beta1.size(); ++i) {
    const T one_more = beta1[i] + T(1.0);
    gamma.push_back(one_more * 2.0 / (beta2[i] + beta1[i] * one_more * 2.0));
    shape.joint.push_back(T(1.0) / one_more);
  }
  for (std::size_t i = 0; i + 1 < beta1.size(); ++i) {
    const T delta = gamma[i] + T(1.0) + beta1[i + 1] * beta1[i + 1] * gamma[i + 1];
    shape.inner1.push_back(gamma[i] / delta);
    shape.inner2.push_back((gamma[i] + T(1.0)) / delta);
  }
  return shape;
}

/// The shape by values that are checked. Errors: bad_argument with the index of the point where β₂ ≤ -2β₁(1+β₁), for
/// there the construction has a pole or folds back.
[[nodiscard]] Expected<BetaShape> beta_shape(std::string_view method, const std::vector<double>& beta1,
                                             const std::vector<double>& beta2);

/// A cubic of a Beta curve on the sphere: where it begins, and the increments between its control points.
template <Number T>
struct BetaSegment {
  Quaternion<T> base;
  std::array<Vector3<T>, 3> increments;
};

/// The one from joint i to the next.
template <Number T>
[[nodiscard]] BetaSegment<T> beta_segment(std::span<const Quaternion<T>> points, const BetaShapeOver<T>& shape,
                                          std::size_t i) {
  const auto inner1 = [&](std::size_t k) { return on_geodesic(points[k], points[k + 1], shape.inner1[k]); };
  const auto inner2 = [&](std::size_t k) { return on_geodesic(points[k], points[k + 1], shape.inner2[k]); };
  const Quaternion<T> before = inner2(i - 1), first = inner1(i), second = inner2(i);  // q_{i,1}, q_{i,2} of the paper
  const Vector3<T> in = displacement(before, first), out = displacement(second, inner1(i + 1));
  return {displaced(before, in * shape.joint[i]),
          {in * (T(1.0) - shape.joint[i]), displacement(first, second), out * shape.joint[i + 1]}};
}

/// The composite cubic from joint 1 to the last but one. Two formulas for one polygon: on the sphere increments are
/// shares of known ones, in space differences of points.
[[nodiscard]] ControlPolygon<Eigen::Quaterniond> beta_polygon(std::span<const Eigen::Quaterniond> points,
                                                              const BetaShape& shape);
[[nodiscard]] ControlPolygon<Eigen::Vector3d> beta_polygon(std::span<const Eigen::Vector3d> points,
                                                           const BetaShape& shape);

}}  // namespace orispline
