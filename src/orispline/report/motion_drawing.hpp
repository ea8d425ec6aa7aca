// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/report/page.hpp>
#include <orispline/report/sphere.hpp>
#include <orispline/report/svg.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// As many methods have a colour of their own in one drawing.
inline constexpr std::size_t most_drawn_methods = 6;

/// More marks of keys would be a grey field: then none are drawn.
inline constexpr std::size_t most_marked_keys = 200;

/// More ghosts in a row would hide each other.
inline constexpr std::size_t most_ghosts = 60;

/// From where ghosts are seen.
[[nodiscard]] inline View view_of_ghosts() { return View({1.0, -0.9, 0.8}); }

/// To sample curves for a drawing: with one column for each unit of the charts' width.
inline constexpr std::size_t samples_to_draw = std::size_t{9} * 660;

/// What a chart of motions shows over time.
struct DrawnQuantity {
  std::string_view word;                              ///< `angle`, `rate`, `acceleration`, `jerk`
  std::string_view title;                             ///< with the unit
  std::vector<double> (*values)(const PageSamples&);  ///< one per time, in the unit
};

/// All of them, as a drawing has them from its top on.
[[nodiscard]] ORISPLINE_EXPORT std::span<const DrawnQuantity> drawn_quantities() noexcept;

/// The motions of methods in one picture.
struct MotionPicture {
  std::string title;
  PageKeys keys;
  std::vector<PageMethod> methods{};                     ///< sampled, at most `most_drawn_methods`
  Eigen::Vector3d body_axis = Eigen::Vector3d::UnitX();  ///< whose way over the unit sphere is drawn
  std::string axis_name = "x";
  std::size_t ghosts = 0;  ///< bodies per method at even times from start to end, below the charts; 0, or from 2 on
};

/// Charts over time [s] of the angle from the start [deg], |ω| [rad/s], |α| [rad/s²] and |jerk| [rad/s³], the keys
/// marked, and beside them the path of a body axis on the unit sphere. Ghosts stand below at their times, a row per
/// method.
[[nodiscard]] ORISPLINE_EXPORT Drawing motion_drawing(const MotionPicture& picture);

}}}  // namespace orispline::report
