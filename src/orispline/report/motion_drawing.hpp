// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/report/page.hpp>
#include <orispline/report/svg.hpp>

namespace orispline::inline ORISPLINE_ABI::report {

/// As many methods have a colour of their own in one drawing.
inline constexpr std::size_t most_drawn_methods = 6;

/// To sample curves for a drawing: with one column for each unit of the charts' width.
inline constexpr std::size_t samples_to_draw = 9 * 660;

/// The motions of methods in one picture.
struct MotionPicture {
  std::string title;
  PageKeys keys;
  std::vector<PageMethod> methods{};                     ///< sampled, at most `most_drawn_methods`
  Eigen::Vector3d body_axis = Eigen::Vector3d::UnitX();  ///< whose way over the unit sphere is drawn
  std::string axis_name = "x";
};

/// Charts over time [s] of the angle from the start [deg], |ω| [rad/s], |α| [rad/s²] and |jerk| [rad/s³], the keys
/// marked, and beside them the path of a body axis on the unit sphere.
[[nodiscard]] ORISPLINE_EXPORT Drawing motion_drawing(const MotionPicture& picture);

}  // namespace orispline::inline ORISPLINE_ABI::report
