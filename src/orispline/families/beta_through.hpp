// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline::inline ORISPLINE_ABI::families {

/// The Beta quaternion spline through the keys: its auxiliary points are solved so that the joints are the keys.
///
/// Beyond the ends the auxiliary points are reflected. G1 at the keys with velocity ratio β₁ (in the local parameter),
/// not G2, as the published one: docs/families/beta-through.md.
struct BetaThrough {
  static constexpr std::array parameters{Parameter{"beta1", 1.0, 1e-6, 1e6, true, 1},
                                         Parameter{"beta2", 0.0, -1e6, 1e6, true, 1}};
  static constexpr FamilyInfo info{
      .name = "beta-through",
      .title = "Beta quaternion spline through the keys",
      .source = "He et al. 2022, section 3.1; control points solved for, docs/families/beta-through.md",
      .continuity_uniform = 1,
      .continuity_uneven = 0,
      .keeps_constant_rate_uniform = true,
      .keeps_constant_rate_uneven = false,
      .support_keys = all_keys,
      .parameters = parameters,
      .key_use = {.feels_times = false}};
  /// Errors: bad_argument with the key index where β₂ ≤ -2β₁(1+β₁); not_converged.
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<CumulativeCurve<CubicBezierBasis, P>> curve(const Keyframes& keys,
                                                                            const FamilySettings& settings);
};

}  // namespace orispline::inline ORISPLINE_ABI::families
