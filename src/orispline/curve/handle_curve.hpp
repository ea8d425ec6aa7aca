// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/slerp_bezier.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The composite cubic of de Casteljau's algorithm; in space that is the cumulative one.
template <CurvePoint P>
using HandleCurve = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, SlerpBezierCurve, CubicBezierPath>;

/// The composite cubic through keys with the rate on leaving and on arriving at each: [rad/s] in the body frame, or
/// [m/s].
template <CurvePoint P>
[[nodiscard]] HandleCurve<P> handle_curve(Knots knots, std::span<const P> keys,
                                          std::span<const Eigen::Vector3d> leaving,
                                          std::span<const Eigen::Vector3d> arriving) {
  std::vector<P> controls{keys[0]};
  controls.reserve(3 * knots.segments() + 1);
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double third = knots.span(i).step() / 3.0;
    controls.insert(controls.end(), {displaced(keys[i], third * leaving[i]),
                                     displaced(keys[i + 1], -third * arriving[i + 1]), keys[i + 1]});
  }
  if constexpr (std::same_as<P, Eigen::Quaterniond>) return SlerpBezierCurve(std::move(knots), controls);
  else return CubicBezierPath(std::move(knots), {}, controls);
}

}}  // namespace orispline
