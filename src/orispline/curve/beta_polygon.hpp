// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// How a Beta curve divides the arcs between its auxiliary points. Source: He et al. 2022, section 3.1.
struct BetaShape {
  std::vector<double> inner1, inner2;  ///< γ_i/Δ_i and (γ_i + 1)/Δ_i, one per arc
  std::vector<double> joint;           ///< 1/(1 + β_{i,1}), one per auxiliary point

  /// Joint i, from its auxiliary point and the neighbours of that.
  template <class P>
  [[nodiscard]] P joint_at(std::size_t i, const P& before, const P& at, const P& after) const {
    return on_geodesic(on_geodesic(before, at, inner2[i - 1]), on_geodesic(at, after, inner1[i]), joint[i]);
  }
};

/// From β₁ and β₂ of every auxiliary point. Errors: bad_argument with the index of the point where β₂ ≤ -2β₁(1+β₁), for
/// there the construction has a pole or folds back.
[[nodiscard]] Expected<BetaShape> beta_shape(std::string_view method, const std::vector<double>& beta1,
                                             const std::vector<double>& beta2);

/// The composite cubic from joint 1 to the last but one. Two formulas for one polygon: on the sphere increments are
/// shares of known ones, in space differences of points.
[[nodiscard]] ControlPolygon<Eigen::Quaterniond> beta_polygon(std::span<const Eigen::Quaterniond> points,
                                                              const BetaShape& shape);
[[nodiscard]] ControlPolygon<Eigen::Vector3d> beta_polygon(std::span<const Eigen::Vector3d> points,
                                                           const BetaShape& shape);

}  // namespace orispline::inline ORISPLINE_ABI
