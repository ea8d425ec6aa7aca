// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/average_curve.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Spherical averages on a cubic B-spline basis: C2 in time on any key times, whatever the order of the control points.
///
/// Knots stand at the key times and are reflected beyond the ends, as the control orientations are. These are solved so
/// that the curve passes through the keys, or are the keys themselves.
struct Averages {
  static constexpr std::array<std::string_view, 2> uses{"through", "control"};
  static constexpr std::array choices{Choice{"points", uses}};
  static constexpr FamilyInfo info{.name = "averages",
                                   .title = "Spline of spherical averages, with cubic B-spline weights",
                                   .source = "Buss & Fillmore 2001; docs/families/averages.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .choices = choices,
                                   .key_use = {.widest_turn = 0.5}};
  /// Errors: not_converged, also where a segment's control orientations lie too far apart to have an average.
  [[nodiscard]] static Expected<AverageCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The cubic spline of the positions: natural, or the B-spline. In space the weighted average is a sum.
  [[nodiscard]] static Expected<CumulativePath<BSplineBasis<3>>> path(const Keyframes& keys,
                                                                      const FamilySettings& settings);
};

}}}  // namespace orispline::families
