// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The 6th-degree spline with one tension β per key: C3 on uniform knots, G3 on others.
///
/// β = 0 stops the motion at a key but keeps an angular acceleration there; β = 5/96 is Xing's quintic of 2018.
struct Sextic {
  static constexpr std::array parameters{tunable(resting_at_zero({"tension", 1.0 / 12.0, -100.0, 100.0}))};
  static constexpr FamilyInfo info{.name = "sextic",
                                   .title = "6th-degree G3 spline with tension",
                                   .source =
                                       "Orientation control via G3 parametric quaternion interpolation spline "
                                       "curves, section 3.1 (erratum: docs/families/sextic.md)",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_repeat,
                                   .closes = true};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 6;
    PerKey tension;

    [[nodiscard]] BernsteinRows<3, 7> coefficients(KnotSpan span) const noexcept {
      const double a = tension[span.i], b = tension[span.i + 1];
      constexpr double w = 1.0 / 12.0;
      return {{{1.0, 1.0 + a, 1.0 - w + 2.0 * a, 1.0, 1.0, 1.0, 1.0},
               {0.0, a, w + 2.0 * a, 0.5, 1.0 - w - 2.0 * b, 1.0 - b, 1.0},
               {0.0, 0.0, 0.0, 0.0, w - 2.0 * b, -b, 0.0}}};
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }
  };

  [[nodiscard]] static Basis basis(const FamilySettings& settings) { return {settings.per_key("tension")}; }
};

}}}  // namespace orispline::families
