// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/refined_chart_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The curve through the keys with the least ∫|α|² dt, the Riemannian cubic; or with the least ∫|torque|² or ∫|jerk|².
///
/// Quintic pieces in the charts at their middles, `nodes` of them in every interval, whose ends are moved to a minimum.
/// The keys' own ω and α are kept where they have them. C2 in time, bi-invariant, symmetric in time. A minimum need not
/// be the only one.
struct Least {
  static constexpr std::array<std::string_view, 3> energies{"acceleration", "torque", "jerk"};
  static constexpr std::array choices{Choice{"energy", energies}};
  static constexpr std::array parameters{Parameter{"nodes", 4.0, 1.0, 64.0, false},
                                         tensor(Parameter{"inertia", 1.0, -1e9, 1e9, false})};
  static constexpr std::array ends{EndRule::natural, EndRule::clamped, EndRule::rest};
  static constexpr FamilyInfo info{.name = "least",
                                   .title = "Curve of least acceleration, torque or jerk",
                                   .source = "Noakes, Heinzinger & Paden 1989; docs/families/least.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = all_keys,
                                   .parameters = parameters,
                                   .choices = choices,
                                   .ends = ends,
                                   .rate_orders = 2};
  /// Errors: not_converged; bad_argument for nodes that are no whole number and an inertia that is not positive
  /// definite.
  [[nodiscard]] static Expected<RefinedChartCurve<5>> curve(const Keyframes& keys, const FamilySettings& settings);
  /// Through the positions: the spline with the least ∫|p̈|² dt, of the jerk that with the least ∫|p⃛|² dt.
  [[nodiscard]] static Expected<HermitePath<5>> path(const Keyframes& keys, const FamilySettings& settings);
};

}}}  // namespace orispline::families
