// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/auto_rates.hpp>
#include <orispline/families/key_findings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Of fewer keys the models take an undersampled stride for noise, and are not weighed.
inline constexpr std::size_t least_weighed = 20;

/// The curve of `auto` with rates that are fitted to what the keys say about themselves: how smooth, how noisy and how
/// certain the motion is.
///
/// Twelve models of motion predict every key from its neighbours and are weighed by their misses. C2 in time on any key
/// times, closed form, bi-invariant, symmetric in time. The weights depend on all keys, unless they are given as
/// settings: then a segment depends on ten. Fewer than nine keys: `auto`. Derivation: docs/families/measured.md.
struct Measured {
  /// The unit of time [s], 0 for the median; the shares of the models, all 0 for those found; how far polynomials are
  /// to be believed, less than 0 for what is found.
  static constexpr std::array parameters{
      Parameter{"interval", 0.0, 0.0, 1e18, false},    Parameter{"spline", 0.0, 0.0, 1.0, false},
      Parameter{"noise3", 0.0, 0.0, 1.0, false},       Parameter{"noise10", 0.0, 0.0, 1.0, false},
      Parameter{"noise20", 0.0, 0.0, 1.0, false},      Parameter{"noise35", 0.0, 0.0, 1.0, false},
      Parameter{"noise50", 0.0, 0.0, 1.0, false},      Parameter{"noise65", 0.0, 0.0, 1.0, false},
      Parameter{"noise80", 0.0, 0.0, 1.0, false},      Parameter{"tension07", 0.0, 0.0, 1.0, false},
      Parameter{"tension15", 0.0, 0.0, 1.0, false},    Parameter{"smooth07", 0.0, 0.0, 1.0, false},
      Parameter{"smooth12", 0.0, 0.0, 1.0, false},     Parameter{"polynomial", -1.0, -1.0, 1.0, false},
      Parameter{"polynomial9", -1.0, -1.0, 1.0, false}};
  /// Where all numbers are given; else none.
  [[nodiscard]] static std::optional<std::size_t> keys_beside(const FamilySettings& settings);
  static constexpr FamilyInfo info{.name = "measured",
                                   .title = "Curve whose rates are fitted to what the keys say about themselves",
                                   .source = "orispline, docs/families/measured.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .parameters = parameters,
                                   .keys_beside = keys_beside};
  [[nodiscard]] static Expected<ChartCurve<5>> curve(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<HermitePath<5>> path(const Keyframes& keys, const FamilySettings& settings);
};

/// What the keys say, or the settings instead. At least `least_window` keys.
[[nodiscard]] KeyFindings findings_of(const Keyframes& keys, Through through, const FamilySettings& settings);

}}}  // namespace orispline::families
