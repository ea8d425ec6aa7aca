// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// What the joint of a key misses it by; auxiliary point i + 1 belongs to key i.
template <Number R>
struct JointToKey {
  static constexpr double forbidden_turn = std::numbers::pi;
  const BetaShapeOver<R>* shape;

  template <class P>
  [[nodiscard]] auto operator()(std::size_t i, const P& before, const P& at, const P& after, const P& key) const {
    return displacement(shape->joint_at(i + 1, before, at, after), key);
  }
};

/// The Beta quaternion spline through the keys: its auxiliary points are solved so that the joints are the keys.
///
/// Beyond the ends the auxiliary points are reflected, around a loop they are those of the other side. G1 at the keys
/// with velocity ratio β₁ (in the local parameter), not G2, as the published one: docs/families/beta-through.md.
struct BetaThrough {
  static constexpr std::array parameters{tunable({"beta1", 1.0, 1e-6, 1e6, true, 1}),
                                         tunable({"beta2", 0.0, -1e6, 1e6, true, 1})};
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
      .closes = true,
      .key_use = {.feels_times = false}};
  /// What the curve is made of: an auxiliary point per key, and how the arcs are divided, those to the ghosts too.
  struct Construction {
    BetaShape shape;
    std::vector<Eigen::Quaterniond> points;
  };
  /// Errors: those of `curve`.
  [[nodiscard]] static Expected<Construction> construction(const Keyframes& keys, const FamilySettings& settings);
  /// Errors: bad_argument with the key index where β₂ ≤ -2β₁(1+β₁); not_converged.
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<CumulativeCurve<CubicBezierBasis, P>> curve(const Keyframes& keys,
                                                                            const FamilySettings& settings);
};

}}}  // namespace orispline::families
