// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/rest_settings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Local, closed form, C2 in time on any key times, and near to the true motion wherever the keys resolve it.
///
/// Every key gets an angular velocity and acceleration from its seven nearest keys: those of the interpolating
/// polynomial where the motion is smooth, those of a natural cubic spline where it is rough. A quintic in the rotation
/// vector then joins the keys. A segment depends on 8 keys. Derivation and measurements: docs/families/auto.md.
struct Auto {
  static constexpr std::array parameters{hold_setting, rest_angle_setting};
  static constexpr FamilyInfo info{.name = "auto",
                                   .title = "Local C2 spline that takes its rates from the keys around",
                                   .source = "orispline, docs/families/auto.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 8,
                                   .parameters = parameters};
  [[nodiscard]] static Expected<ChartCurve<5>> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<HermitePath<5>> path(const Keyframes& keys, const FamilySettings& settings);
};

/// The steps of `auto` from five keys: a segment depends on 6 keys, for less latency.
struct Auto5 {
  static constexpr std::array parameters{hold_setting, rest_angle_setting};
  static constexpr FamilyInfo info{.name = "auto5",
                                   .title = "Local C2 spline that takes its rates from five keys",
                                   .source = "orispline, docs/families/auto5.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 6,
                                   .parameters = parameters};
  [[nodiscard]] static Expected<ChartCurve<5>> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<HermitePath<5>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
