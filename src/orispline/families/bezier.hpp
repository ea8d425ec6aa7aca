// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Composite cumulative cubic Bézier curve: every third key is a joint, the two between shape the segment.
///
/// The times of the inner control points are ignored. C0 unless the handles are laid out smoothly.
struct Bezier {
  static constexpr FamilyInfo info{.name = "bezier",
                                   .title = "Cumulative cubic Bezier curve",
                                   .source = "Kim, Kim & Shin 1995; docs/families/bezier.md",
                                   .interpolates = false,
                                   .continuity_uniform = 0,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .min_keys = 4,
                                   .key_use = {.stride = 3}};
  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<CumulativeCurve<CubicBezierBasis, P>> curve(const Keyframes& keys,
                                                                            const FamilySettings&);
};

}}}  // namespace orispline::families
