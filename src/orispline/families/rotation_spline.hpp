// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// McEnnan's spline, SciPy's RotationSpline: a cubic rotation vector from every key to the next, C2 in time on any
/// knots.
///
/// With secant ends it is SciPy's curve. Bi-invariant, not symmetric in time: the chart stands at the earlier key.
struct RotationSpline {
  static constexpr std::array ends{EndRule::secant, EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "rotation-spline",
                                   .title = "Rotation spline of McEnnan and SciPy",
                                   .source = "McEnnan 2003; docs/families/rotation-spline.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .ends = ends,
                                   .closes = true};
  /// Errors: not_converged.
  [[nodiscard]] static Expected<ChartCurve<3>> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
