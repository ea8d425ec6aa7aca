// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include <orispline/curve/four_key_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// The type of the algebraic-trigonometric blending spline: the one local interpolant of four keys that is C2 on
/// uniform knots with blending functions in the span of 1, u, u², sin πu and cos πu.
///
/// The basis of the paper itself was not at hand. With the increments a before and b after a key the rate there is
/// (a + b)/(2h).
struct Atbi {
  static constexpr FamilyInfo info{
      .name = "atbi",
      .title = "Spline of the algebraic-trigonometric type, made of 1, u, u2, sin and cos",
      .source = "derived, docs/families/atbi.md; the basis of Su, Zhang & Wang 2013 was not at hand",
      .continuity_uniform = 2,
      .continuity_uneven = 0,
      .keeps_constant_rate_uniform = true,
      .keeps_constant_rate_uneven = false,
      .support_keys = 4,
      .ends = four_key_ends_natural,
      .closes = true};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 0;  // no polynomials
    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      constexpr double pi = std::numbers::pi;
      const T u = span.normalised(t);
      // Behind the middle by the angle that is left: at the end the sine is 0 then, and what lies beyond it does not
      // count, however far that is.
      const bool is_late = value_of(u) > 0.5;
      T sine, cosine;
      sin_cos(T((is_late ? T(1.0) - u : u) * pi), sine, cosine);
      if (is_late) cosine = -cosine;
      // C_3 mirrors C_0: their sum and their difference. C_2 follows from C_0 + … + C_3 = 1 and -C_0 + C_2 + 2 C_3 = u.
      const T sum = (u * u - u) * (pi * pi / 8.0) + sine * ((pi * pi / 4.0 - 1.0) / (2.0 * pi));
      const T difference = (T(1.0) - u * 2.0 - cosine) * 0.25;
      return {T(1.0) - (sum + difference) * 0.5, u + difference, (sum - difference) * 0.5};
    }
  };
  [[nodiscard]] static Basis basis(const FamilySettings&) { return {}; }
};

}}}  // namespace orispline::families
