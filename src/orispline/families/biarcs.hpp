// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/biarc_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Two circular arcs of S³ from key to key, which meet with one tangent; their length is run through by a monotone
/// cubic of time: C1 in time on any knots.
///
/// Where the body turns back or rests, it stops in the key. The same construction on straight lines and circles of
/// space for positions.
struct Biarcs {
  static constexpr std::array ends{EndRule::natural, EndRule::rest};
  static constexpr FamilyInfo info{.name = "biarcs",
                                   .title = "Spherical biarcs",
                                   .source = "Wang & Joe 1993; tangents and time: docs/families/biarcs.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 6,
                                   .ends = ends,
                                   .closes = true};
  template <CurvePoint P>
  [[nodiscard]] static Expected<BiarcCurve<P>> curve(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
