// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/curve/track.hpp>
#include <orispline/pages/page_head.hpp>
#include <orispline/report/page.hpp>

namespace orispline::inline ORISPLINE_ABI::pages {

/// The page to look at of one curve: its motion with the keys, and the measures of its shape. With an inertia [kg m²]
/// its torques are shown and measured too. Errors: those of make_pose_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<report::Page> motion_page(const Track& track, const Method& method,
                                                                  const PageHead& head,
                                                                  const std::optional<Eigen::Matrix3d>& inertia = {});

}  // namespace orispline::inline ORISPLINE_ABI::pages
