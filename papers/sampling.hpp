// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/report/chart.hpp>

#include "papers/recipe.hpp"

namespace orispline::cli {

/// `count` times from the start to the end of a domain, evenly spaced [s].
[[nodiscard]] std::vector<double> even_times(Domain domain, std::size_t count);

/// Where an axis of the body points in the world, along the curve.
[[nodiscard]] std::vector<Eigen::Vector3d> axis_path(const AnyCurve& curve, std::span<const double> times,
                                                     const Eigen::Vector3d& axis);
[[nodiscard]] std::vector<Eigen::Vector3d> axis_path(std::span<const Eigen::Quaterniond> orientations,
                                                     const Eigen::Vector3d& axis);

/// A figure of the motion over time, segment by segment: where it jumps at a key, the series breaks.
[[nodiscard]] report::Series over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure);

/// The largest value of a figure of the motion, over 100 times in each segment and its two ends.
[[nodiscard]] double largest_over_time(const AnyCurve& curve, const std::function<double(const Motion&)>& figure);

/// The largest angle between two curves at the times [rad].
[[nodiscard]] double largest_distance(const AnyCurve& a, const AnyCurve& b, std::span<const double> times);

/// Marks at the knots.
[[nodiscard]] std::vector<report::Mark> marks_at(std::span<const double> knots);

/// Median time that work takes [s], of nine times.
[[nodiscard]] double seconds_of(const std::function<void()>& work);

/// Likewise, to build a curve and to compute so many frames of it [s].
[[nodiscard]] double seconds_for(const Recipe& recipe, const Keyframes& keys, std::size_t frames);

inline const auto speed = [](const Motion& m) { return m.angular_velocity.norm(); };             // [rad/s]
inline const auto acceleration = [](const Motion& m) { return m.angular_acceleration.norm(); };  // [rad/s²]

}  // namespace orispline::cli
