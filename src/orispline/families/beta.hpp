// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The Beta quaternion spline as published: approximates its keys, which are auxiliary control points.
///
/// Control point i sits at time t_i; the curve runs from t_1 to t_{n-2}, joint k at t_{k+1}, of a loop all around it.
/// G1 at the joints with velocity ratio β₁ (in the local parameter); not G2, whatever the paper says:
/// docs/families/beta.md.
struct Beta {
  static constexpr std::array parameters{tunable({"beta1", 1.0, 1e-6, 1e6}), tunable({"beta2", 0.0, -1e6, 1e6})};
  static constexpr FamilyInfo info{.name = "beta",
                                   .title = "Beta quaternion spline",
                                   .source = "He et al. 2022, section 3.1, (4) (errata: docs/families/beta.md)",
                                   .interpolates = false,
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .min_keys = 4,
                                   .parameters = parameters,
                                   .closes = true,
                                   .key_use = {.first = 1, .parameters_reach_far = true}};
  /// Errors: bad_argument with the key index where β₂ ≤ -2β₁(1+β₁), for there the construction has a pole or folds
  /// back.
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<CumulativeCurve<CubicBezierBasis, P>> curve(const Keyframes& keys,
                                                                            const FamilySettings& settings);
};

}}}  // namespace orispline::families
