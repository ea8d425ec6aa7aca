// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Cumulative B-spline of degree 2…5 on the key times: approximates its keys, C^(degree-1) in time on any knots.
///
/// It runs from the first key time to the last; on even times it starts and ends at those keys. Knots stand at the key
/// times for odd degrees and at the midpoints for even ones, and go on with the end spacing; control orientations
/// beyond the ends are the keys reflected at the end key.
struct BSpline {
  static constexpr std::array parameters{Parameter{"degree", 3.0, 2.0, 5.0, false}};
  /// The knots of a span, which of even degrees are midpoints between keys.
  [[nodiscard]] static std::optional<std::size_t> keys_beside(const FamilySettings& settings) {
    return 2 * (static_cast<std::size_t>(settings.per_key("degree")[0]) / 2);
  }
  static constexpr FamilyInfo info{.name = "bspline",
                                   .title = "Cumulative B-spline",
                                   .source = "Kim, Kim & Shin 1995; docs/families/bspline.md",
                                   .interpolates = false,
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .key_use = {.further_times = 1},
                                   .keys_beside = keys_beside};

  template <CurvePoint P = Eigen::Quaterniond>
  [[nodiscard]] static Expected<AnyCurveThrough<P>> curve(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
