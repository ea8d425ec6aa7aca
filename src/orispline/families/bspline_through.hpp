// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Kim's cumulative cubic B-spline through the keys: its control orientations are solved for. C2 in time on any knots.
///
/// The knots are the key times; those beyond the ends are mirrored there, or with phantom=equal go on with the end
/// spacing.
struct BSplineThrough {
  static constexpr std::array<std::string_view, 2> phantoms{"reflect", "equal"};
  static constexpr std::array choices{Choice{"phantom", phantoms}};
  static constexpr std::array ends{EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "bspline-through",
                                   .title = "Cumulative B-spline through the keys",
                                   .source = "Kim, Kim & Shin 1995; docs/families/bspline-through.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .choices = choices,
                                   .ends = ends,
                                   .closes = true,
                                   .key_use = {.widest_turn = 0.8}};
  /// Errors: not_converged, as on widely turning keys with uneven times.
  [[nodiscard]] static Expected<CumulativeCurve<BSplineBasis<3>>> curve(const Keyframes& keys,
                                                                        const FamilySettings& settings);
  /// The cubic spline through the positions: in space the equations are linear.
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
