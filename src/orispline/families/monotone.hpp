// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/rest_settings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Cubics that turn about the axis of each step and never back: C1 in time on any key times, and no farther from the
/// geodesic between two keys than 0.42 times their step.
///
/// The rate at a key is what both steps beside it bear, so that a key between two opposite steps, and one beside a step
/// of no turn, is a rest. About one axis the angle is that of SciPy's PchipInterpolator.
struct Monotone {
  static constexpr std::array parameters{rest_angle_setting};
  static constexpr FamilyInfo info{
      .name = "monotone",
      .title = "Monotone cubics that do not go beyond their keys",
      .source = "Fritsch & Carlson 1980, Fritsch & Butland 1984; docs/families/monotone.md",
      .continuity_uniform = 1,
      .continuity_uneven = 1,
      .keeps_constant_rate_uniform = true,
      .keeps_constant_rate_uneven = true,
      .support_keys = 4,
      .parameters = parameters,
      .closes = true};
  [[nodiscard]] static Expected<ChartCurve<3>> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
