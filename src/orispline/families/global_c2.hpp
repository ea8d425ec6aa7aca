// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/rate_chain.hpp>
#include <orispline/curve/slerp_bezier.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The C2 curve of slerp cubics whose rates at the keys solve for equal accelerations: close to the least ∫|α|².
///
/// Symmetric in time, bi-invariant, C2 in time on any knots. With ν at a key the acceleration jumps there by ν ω, which
/// tightens the curve: see nu-exact.
struct GlobalC2 {
  static constexpr std::array parameters{Parameter{"nu", 0.0, -1e9, 1e9}};
  static constexpr std::array ends{EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "global-c2",
                                   .title = "Global C2 spline of slerp cubics",
                                   .source = "Bogfjellmo, Modin & Verdier 2018; docs/families/global-c2.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .parameters = parameters,
                                   .ends = ends,
                                   .closes = true,
                                   .key_use = {.smoothest_with_parameters = 1}};
  /// Errors: not_converged.
  [[nodiscard]] static Expected<SlerpBezierCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The cubic spline: in space the equations are linear in the velocities.
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

/// Nielson's ν-spline with its condition exact on the sphere: α⁺ - α⁻ = ν ω at every inner key, ν in 1/s.
///
/// The curve of global-c2 under its tension: at ν = 0 they are the same and C2, else C1.
struct NuExact {
  static constexpr std::array parameters{tunable(GlobalC2::parameters.front())};
  static constexpr FamilyInfo info{.name = "nu-exact",
                                   .title = "Nu-spline, exact on the sphere",
                                   .source = "orispline, docs/families/nu-exact.md; the condition is of Nielson 1974",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .parameters = parameters,
                                   .ends = GlobalC2::ends,
                                   .closes = true,
                                   .key_use = {.smoothest_with_parameters = 1}};
  /// The rates at the keys, with the equations that they solve. Errors: not_converged.
  [[nodiscard]] static Expected<RateChain<SlerpBezierPiece>> rates(const Keyframes& keys,
                                                                   const FamilySettings& settings);
  /// Errors: not_converged.
  [[nodiscard]] static Expected<SlerpBezierCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The cubic spline: in space the equations are linear in the velocities.
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
