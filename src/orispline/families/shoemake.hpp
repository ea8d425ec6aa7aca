// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/handle_curve.hpp>
#include <orispline/curve/handle_rates.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Shoemake's Bézier curve of slerps: the handles of a key lie on the geodesic that bisects the way to its next key
/// from the step before, continued.
///
/// By default the step is continued and bisected in time, which makes the curve C1 on any key times; as published the
/// times are ignored, and on uneven ones the curve is only G1. On even times both are the same.
struct Shoemake {
  static constexpr std::array<std::string_view, 2> timings{"time", "published"};
  static constexpr std::array choices{Choice{"timing", timings}};
  static constexpr std::array ends{EndRule::natural};
  static constexpr FamilyInfo info{.name = "shoemake",
                                   .title = "Shoemake's Bezier curve of slerps",
                                   .source = "Shoemake 1985; made C1 in time, docs/families/shoemake.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .choices = choices,
                                   .ends = ends};
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<HandleCurve<P>> curve(const Keyframes& keys, const FamilySettings& settings);
  /// The handle that turns farthest, or the step continued to find one; from a full turn on the curve goes elsewhere or
  /// C1 is lost.
  [[nodiscard]] static HandleTurn widest_handle(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
