// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include <orispline/math/eigensystem.hpp>
#include <orispline/mean/weighted.hpp>

// Points on one axis: their median is that of numbers, and may be a range.

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// The middle of all medians, and how far the others go on both sides of it.
template <CurvePoint P>
struct AxisMedian {
  P point;
  double half_range = 0.0;
};

/// The axis on which all points lie beside one of them or between them; nothing where they do not.
template <CurvePoint P>
[[nodiscard]] std::optional<Eigen::Vector3d> common_axis(const Weighted<P>& given, const P& beside) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Eigen::Vector3d way = way_to(beside, given.points[k]).vector;
    moments += given.weights[k] * way * way.transpose();
  }
  const Eigensystem<3> axes = eigensystem<3>(moments);
  const Eigen::Vector3d& squares = axes.values;
  const bool is_one = squares[2] > 0.0 && squares[1] <= 1e-20 * squares[2];
  return is_one ? std::optional(Eigen::Vector3d(axes.vectors.col(2))) : std::nullopt;
}

/// The median of points on an axis through a point beside them.
template <CurvePoint P>
[[nodiscard]] AxisMedian<P> median_on_axis(const Weighted<P>& given, const P& beside, const Eigen::Vector3d& axis) {
  std::vector<std::size_t> order(given.size());
  std::vector<double> places(given.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = 0; k < given.size(); ++k) places[k] = axis.dot(way_to(beside, given.points[k]).vector);
  std::ranges::sort(order, {}, [&](std::size_t k) { return places[k]; });
  double below = 0.0;
  std::size_t i = 0;
  while (i + 1 < order.size() && below + given.weights[order[i]] < 0.5 - 1e-12) below += given.weights[order[i++]];
  const P& lower = given.points[order[i]];
  const bool is_range = i + 1 < order.size() && below + given.weights[order[i]] <= 0.5 + 1e-12;
  if (!is_range) return {lower};
  const Eigen::Vector3d half = 0.5 * way_to(lower, given.points[order[i + 1]]).vector;
  return {moved(lower, half), norm_of<double>(half)};
}

}}}  // namespace orispline::mean_of
