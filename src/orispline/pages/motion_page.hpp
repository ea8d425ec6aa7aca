// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include <orispline/curve/pose_curve.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/pages/page_head.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// The page to look at of one curve: its motion with the keys, and the measures of its shape. With an inertia [kg m²]
/// its torques are shown and measured too. Errors: those of make_pose_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<report::Page> motion_page(const Track& track, const Method& method,
                                                                  const PageHead& head,
                                                                  const std::optional<Eigen::Matrix3d>& inertia = {});

/// A curve of any making, with the keys that it is for.
struct NamedCurve {
  std::string name;  ///< unlike those beside it
  Keyframes keys;
  PoseCurve curve;
};

/// The page to look at of curves side by side, one at least, each with its own keys, with the measures of their shapes.
/// With a truth, orientations over time, it has the angles of all of them to it. Its title is that of the head.
[[nodiscard]] ORISPLINE_EXPORT report::Page curves_page(std::span<const NamedCurve> curves, const PageHead& head,
                                                        const Keyframes& truth = {});

}}}  // namespace orispline::pages
