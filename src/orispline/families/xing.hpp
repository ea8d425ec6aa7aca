// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/math/bernstein.hpp>

// The two splines without parameters that the 6th-degree paper compares with. Their papers give only degree and
// continuity in what we could read; the blending functions are the unique ones of that degree and continuity.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The quartic: C2 on uniform knots. C_0 = -½ u(1-u)³ and its mirror; second differences count threefold at a key.
struct XingQuartic {
  static constexpr FamilyInfo info{.name = "xing-quartic",
                                   .title = "Xing's quartic C2 spline",
                                   .source = "derived, docs/families/xing-quartic.md; after Xing et al. 2017",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .ends = four_key_ends_repeat,
                                   .closes = true};
  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 4;
    [[nodiscard]] static constexpr BernsteinRows<3, 5> coefficients(KnotSpan) noexcept {
      return {{{1.0, 9.0 / 8.0, 1.0, 1.0, 1.0},
               {0.0, 1.0 / 8.0, 1.0 / 2.0, 7.0 / 8.0, 1.0},
               {0.0, 0.0, 0.0, -1.0 / 8.0, 0.0}}};
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }
  };
  [[nodiscard]] static Basis basis(const FamilySettings&) { return {}; }
};

/// The quintic: C3 on uniform knots; the 6th-degree spline at β = 5/96. Its rate ripples on a steady rotation.
struct XingQuintic {
  static constexpr FamilyInfo info{.name = "xing-quintic",
                                   .title = "Xing's quintic C3 spline",
                                   .source = "derived, docs/families/xing-quintic.md; after Xing, Bai, Fan & Tan 2018",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 0,
                                   .keeps_constant_rate_uniform = false,
                                   .keeps_constant_rate_uneven = false,
                                   .support_keys = 4,
                                   .ends = four_key_ends_repeat,
                                   .closes = true};
  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 5;
    [[nodiscard]] static constexpr BernsteinRows<3, 6> coefficients(KnotSpan) noexcept {
      return {{{1.0, 17.0 / 16.0, 1.0, 1.0, 1.0, 1.0},
               {0.0, 1.0 / 16.0, 1.0 / 4.0, 3.0 / 4.0, 15.0 / 16.0, 1.0},
               {0.0, 0.0, 0.0, 0.0, -1.0 / 16.0, 0.0}}};
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }
  };
  [[nodiscard]] static Basis basis(const FamilySettings&) { return {}; }
};

}}}  // namespace orispline::families
