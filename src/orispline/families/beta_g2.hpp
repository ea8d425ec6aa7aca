// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/beta_g2_handles.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Beta quaternion splines that are truly G2: s'' after a joint is β₁² s'' + β₂ s' before it, in the local parameter.
///
/// `local` is the published curve with every segment corrected from its left joint, near its keys as `beta` is;
/// `global` passes through its keys with handles solved for. Derivation: docs/families/beta-g2.md.
struct BetaG2 {
  static constexpr std::array parameters{tunable({"beta1", 1.0, 1e-6, 1e6}), tunable({"beta2", 0.0, -1e6, 1e6})};
  static constexpr std::array<std::string_view, 2> forms{"local", "global"};
  static constexpr std::array choices{Choice{"form", forms}};
  [[nodiscard]] static bool is_global(const FamilySettings& settings) { return settings.choice("form") == "global"; }
  /// A correction of the acceleration needs the segment before, but not its keys.
  [[nodiscard]] static std::optional<std::size_t> keys_beside(const FamilySettings& settings) {
    return is_global(settings) ? std::nullopt : std::optional<std::size_t>(2);
  }
  static constexpr FamilyInfo info{.name = "beta-g2",
                                   .title = "Beta quaternion spline, truly G2",
                                   .source = "orispline, docs/families/beta-g2.md",
                                   .interpolates = false,
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .min_keys = 4,
                                   .parameters = parameters,
                                   .choices = choices,
                                   .closes = true,
                                   .key_use = {.first = 1, .parameters_reach_far = true},
                                   .keys_beside = keys_beside};

  /// A cubic Bézier segment times exp(w(u) z), w = u²(1-u)³/2: it changes nothing but the acceleration at u = 0, by z.
  struct Basis {
    static constexpr std::size_t increments = 4, stride = 4;
    static constexpr int degree = 5;
    template <Number T>
    [[nodiscard]] std::array<T, 4> operator()(KnotSpan span, const T& t) const noexcept {
      const std::array<T, 3> cubic = CubicBezierBasis{}(span, t);
      const T u = span.normalised(t), v = T(1.0) - u;
      return {cubic[0], cubic[1], cubic[2], u * u * v * v * v * T(0.5)};
    }
  };

  /// The handles of the form `global`, with the equations that they solve. Errors: not_converged.
  [[nodiscard]] static Expected<HandleChain<Eigen::Quaterniond>> handles(const Keyframes& keys,
                                                                         const FamilySettings& settings);
  /// Errors: bad_argument with the key index where β₂ ≤ -2β₁(1+β₁); not_converged.
  [[nodiscard]] static Expected<CumulativeCurve<Basis>> curve(const Keyframes& keys, const FamilySettings& settings);
  /// In space the published curve is G2 by itself and needs no corrections.
  [[nodiscard]] static Expected<CubicBezierPath> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
