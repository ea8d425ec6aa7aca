// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/handle_curve.hpp>
#include <orispline/curve/handle_rates.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Kochanek–Bartels: a Bézier curve of slerps with tension, continuity and bias at every key.
///
/// C1 in time on any knots where the continuity parameter is 0; tension 1 stops the motion at the key.
struct Tcb {
  static constexpr std::array parameters{tunable({"tension", 0.0, -100.0, 100.0}),
                                         Parameter{"continuity", 0.0, -100.0, 100.0},
                                         Parameter{"bias", 0.0, -100.0, 100.0}};
  static constexpr std::array ends{EndRule::natural, EndRule::handle};
  static constexpr FamilyInfo info{.name = "tcb",
                                   .title = "Kochanek-Bartels spline of slerps",
                                   .source = "Kochanek & Bartels 1984; docs/families/tcb.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = ends};
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<HandleCurve<P>> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The handle that turns farthest; C1 is lost from a full turn on.
  [[nodiscard]] static HandleTurn widest_handle(const Keyframes& keys, const FamilySettings& settings);
  /// The rates on leaving and on arriving at every key [rad/s], affine in the tension of that key under natural ends.
  [[nodiscard]] static HandleRates handle_rates(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
