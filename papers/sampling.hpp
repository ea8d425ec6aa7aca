// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>
#include <orispline/report/table.hpp>

#include "papers/recipe.hpp"

namespace orispline::cli {

/// `count` times from the start to the end of a domain, evenly spaced [s].
[[nodiscard]] std::vector<double> even_times(Domain domain, std::size_t count);

/// Where an axis of the body points in the world, along the curve.
[[nodiscard]] std::vector<Eigen::Vector3d> axis_path(const AnyCurve& curve, std::span<const double> times,
                                                     const Eigen::Vector3d& axis);
[[nodiscard]] std::vector<Eigen::Vector3d> axis_path(std::span<const Eigen::Quaterniond> orientations,
                                                     const Eigen::Vector3d& axis);

/// The paths of an axis of the body along curves, with dots at the keys, which are numbered from 1.
[[nodiscard]] report::SpherePicture sphere_of(std::span<const Served> curves, const Keyframes& keys,
                                              const Eigen::Vector3d& axis);

/// A figure of the motion over time, segment by segment: where it jumps at a key, the series breaks.
[[nodiscard]] report::Series over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure);

/// The largest value of a figure of the motion: over 100 times in each segment and its two ends, then beside the
/// highest of them.
[[nodiscard]] double largest_over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure);

/// The largest angle between two curves at the times [rad].
[[nodiscard]] double largest_distance(const AnyCurve& a, const AnyCurve& b, std::span<const double> times);

/// A figure of the motion over time, named and drawn as the recipe of its curve says.
[[nodiscard]] report::Series over_time(const Served& served, const std::function<double(const Motion&)>& figure);

/// Series without points, for a legend.
[[nodiscard]] std::vector<report::Series> names_of(std::span<const Served> curves);

/// Marks at the knots, with their times where there is room for these.
[[nodiscard]] std::vector<report::Mark> marks_at(std::span<const double> knots);

/// Median times that works take the processor [s], of nine rounds. They work in this thread only. A round does each of
/// them once, so that what slows the machine for a while slows all of them.
[[nodiscard]] std::vector<double> seconds_in_turn(std::span<const std::function<void()>> works);

/// The work to build a curve through keys and to compute its orientations at times [s]. The keys and times are not
/// copied.
[[nodiscard]] std::function<void()> building(const Recipe& recipe, const Keyframes& keys,
                                             const std::vector<double>& times);

inline const auto speed = [](const Motion& m) { return m.angular_velocity.norm(); };             // [rad/s]
inline const auto acceleration = [](const Motion& m) { return m.angular_acceleration.norm(); };  // [rad/s²]

/// What has no value, such as the curvature at a rest, is a dash.
[[nodiscard]] report::Cell finite_or_dash(double value);

/// The speed of the body's point at distance 1 along an axis [1/s].
[[nodiscard]] inline auto speed_of_point(const Eigen::Vector3d& axis) {
  return [axis](const Motion& m) { return m.angular_velocity.cross(axis).norm(); };
}

}  // namespace orispline::cli
