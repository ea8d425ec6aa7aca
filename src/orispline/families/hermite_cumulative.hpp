// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/catmull_rom_path.hpp>
#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Kim's cubic Hermite curve: C1 in time on any knots through given or estimated rates at the keys.
///
/// The rates are the keys' angular velocities where they have them, else those of the parabola through three keys, at
/// the ends the secants; the tension scales them.
struct HermiteCumulative {
  static constexpr std::array parameters{tunable(resting_at_zero({"tension", 1.0, -100.0, 100.0}))};
  static constexpr FamilyInfo info{.name = "hermite-cumulative",
                                   .title = "Cumulative cubic Hermite curve",
                                   .source = "Kim, Kim & Shin 1995; docs/families/hermite-cumulative.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .rate_orders = 1};
  /// The rates [rad/s] that a tension of 1 has at the keys: those given, else, and where they are free,
  /// estimated from three keys.
  [[nodiscard]] static std::vector<Eigen::Vector3d> key_rates(const Keyframes& keys);
  [[nodiscard]] static Expected<CubicBezierCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// Catmull–Rom in time: the angular rates of the keys say nothing about positions.
  [[nodiscard]] static Expected<CatmullRomPath> path(const Keyframes& keys, const FamilySettings& settings) {
    return CatmullRomPath(keys, settings.per_key("tension"));
  }
};

}}}  // namespace orispline::families
