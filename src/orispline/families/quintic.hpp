// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Tan's quintic spline with one tension α per key: C2 on uniform knots, G2 on others.
///
/// With the increments a before and b after a key the angular velocity there is α (a + b)/h and the angular
/// acceleration α (b - a)/h² + α² a×b/h²: α = 0 stops the motion at the key, a negative α turns back there.
struct Quintic {
  static constexpr std::array parameters{tunable(resting_at_zero({"tension", 0.5, -100.0, 100.0}))};
  static constexpr FamilyInfo info{.name = "quintic",
                                   .title = "Tan's quintic G2 spline with tension",
                                   .source = "Tan, Xing, Fan & Hong 2018, (3.2) and (3.6)",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_repeat,
                                   .closes = true};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 5;
    PerKey tension;

    [[nodiscard]] BernsteinRows<3, 6> coefficients(KnotSpan span) const noexcept {
      const double a = tension[span.i], b = tension[span.i + 1];
      return {{{1.0, 1.0 + a / 5.0, 1.0 + 7.0 * a / 20.0, 1.0, 1.0, 1.0},
               {0.0, a / 5.0, 9.0 * a / 20.0, 1.0 - 9.0 * b / 20.0, 1.0 - b / 5.0, 1.0},
               {0.0, 0.0, 0.0, -7.0 * b / 20.0, -b / 5.0, 0.0}}};
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }
  };

  [[nodiscard]] static Basis basis(const FamilySettings& settings) { return {settings.per_key("tension")}; }
};

}}}  // namespace orispline::families
