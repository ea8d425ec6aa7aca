// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/slerp_bezier.hpp>
#include <orispline/families/nu_construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Nielson's ν-quaternion spline as published: slerp cubics on control orientations that solve for passing through the
/// keys. A tension ν [1/s] at every key, C1 in time on any knots.
///
/// In space it is the ν-spline, whose acceleration jumps by ν times the velocity; on the sphere that holds only nearly,
/// see nu-exact.
struct Nu {
  static constexpr std::array parameters{tunable({"nu", 0.0, -1e9, 1e9})};
  static constexpr std::array ends{EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "nu",
                                   .title = "Nu-quaternion spline",
                                   .source = "Nielson 1993 and 2004; docs/families/nu.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .parameters = parameters,
                                   .ends = ends,
                                   .key_use = {.widest_turn = 0.8}};
  /// What the curve is made of: one control orientation per key, and where the inner points of the cubics lie between.
  struct Construction {
    NuRule<double> rule;
    std::vector<Eigen::Quaterniond> controls;
  };
  /// Errors: those of `curve`.
  [[nodiscard]] static Expected<Construction> construction(const Keyframes& keys, const FamilySettings& settings);
  /// Errors: bad_argument where ν is so negative that the construction has a pole, or where an end rate makes a handle
  /// of a full turn; not_converged.
  [[nodiscard]] static Expected<SlerpBezierCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The cubic ν-spline: in space the equations are linear in the velocities.
  [[nodiscard]] static Expected<HermitePath<3>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
