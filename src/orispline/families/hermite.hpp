// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/cumulative_hermite.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Hermite interpolation of orders 1…K: a polynomial of degree 2K+1 in the rotation vector from the key before, with
/// the body rates of both keys; C^K in time on any key times.
///
/// The keys' own rates are used for the orders that they have, the others are those of the polynomial through the
/// `stencil` nearest keys. The form `cumulative` is a product of 2K+1 exponentials with the same rates at the keys.
template <std::size_t K>
struct Hermite {
  static constexpr std::array<std::string_view, 2> stencils{"5", "3"};
  static constexpr std::array<std::string_view, 2> forms{"chart", "cumulative"};
  static constexpr std::array choices{Choice{"stencil", stencils}, Choice{"form", forms}};
  static constexpr std::array<std::string_view, 3> names{"hermite-c1", "hermite-c2", "hermite-c3"};
  static constexpr std::array<std::string_view, 3> titles{"Cubic Hermite curve through rates of the keys",
                                                          "Quintic Hermite curve through rates of the keys",
                                                          "Septic Hermite curve through rates of the keys"};
  static constexpr FamilyInfo info{.name = names[K - 1],
                                   .title = titles[K - 1],
                                   .source = "two-point Hermite interpolation, docs/families/hermite.md",
                                   .continuity_uniform = K,
                                   .continuity_uneven = K,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 6,
                                   .choices = choices,
                                   .rate_orders = K};
  /// In the form that is chosen. Error (bad_data) in the chart: a step of a full turn.
  [[nodiscard]] static Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// Space needs no chart, and the keys have no rates there.
  [[nodiscard]] static Expected<HermitePath<2 * K + 1>> path(const Keyframes& keys, const FamilySettings& settings);

  using Cumulative = CumulativeCurve<CumulativeBernsteinBasis<2 * K + 1>>;
  [[nodiscard]] static Expected<ChartCurve<2 * K + 1>> chart(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Cumulative cumulative(const Keyframes& keys, const FamilySettings& settings);
};

extern template struct Hermite<1>;
extern template struct Hermite<2>;
extern template struct Hermite<3>;
using HermiteC1 = Hermite<1>;
using HermiteC2 = Hermite<2>;
using HermiteC3 = Hermite<3>;

}}}  // namespace orispline::families
