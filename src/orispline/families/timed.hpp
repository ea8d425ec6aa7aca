// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/two_point_blending.hpp>
#include <orispline/math/bernstein.hpp>

// Local interpolating splines that are C1, C2, C3 in time on any knots.
//
// The derivatives φ, ψ of the two factors beside a key belong to the key, not to a segment: the curve is C^k in time
// whatever they are. The values below make the parabola through three keys with tensions ½ and 1:
// docs/families/timed.md.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace timed {

/// φ₁, ψ₁ with tension τ₁; ½ is the tangent of the parabola through three keys. `before`, `after`: the knot steps [s].
[[nodiscard]] inline KnotDerivatives<1> first(double before, double after, double tension) noexcept {
  const double both = before + after;
  return {{2.0 * tension * after / (before * both)}, {2.0 * tension * before / (after * both)}};
}

inline constexpr Parameter tension_1 = resting_at_zero({"tension", 0.5, -100.0, 100.0});
inline constexpr Parameter tension_2{"tension2", 1.0, -100.0, 100.0};
inline constexpr Parameter tension_3{"tension3", 0.0, -100.0, 100.0};

/// Blending functions that are C^K in time.
template <std::size_t K>
struct Basis {
  static constexpr std::size_t increments = 3, stride = 1;
  static constexpr int degree = 2 * static_cast<int>(K) + 1;
  std::array<PerKey, K> tensions;

  [[nodiscard]] FourKeyBlending<K> coefficients(KnotSpan span) const noexcept {
    const double before = span.previous_step(), h = span.step(), after = span.next_step();
    return two_point_blending<K>(scaled(at_key(span.i, before, h), h), scaled(at_key(span.i + 1, h, after), h));
  }

  template <Number T>
  [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
    return bernstein_sums(coefficients(span), span.normalised(t));
  }

  [[nodiscard]] KnotDerivatives<K> at_key(std::size_t key, double before, double after) const noexcept {
    const auto [phi1, psi1] = first(before, after, tensions[0][key]);
    KnotDerivatives<K> d{{phi1[0]}, {psi1[0]}};
    const double both = before + after;
    if constexpr (K >= 2) {
      d.phi[1] = -2.0 * tensions[1][key] / (before * both);
      d.psi[1] = 2.0 * tensions[1][key] / (after * both);
    }
    if constexpr (K >= 3) {
      d.phi[2] = 2.0 * tensions[2][key] / (before * before * both);
      d.psi[2] = 2.0 * tensions[2][key] / (after * after * both);
    }
    return d;
  }
};

}  // namespace timed

/// Cubic, C1 in time on any knots.
struct TimedC1 {
  static constexpr std::array parameters{tunable(timed::tension_1)};
  static constexpr FamilyInfo info{.name = "timed-c1",
                                   .title = "Local cubic spline, C1 in time",
                                   .source = "orispline, docs/families/timed-c1.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural,
                                   .closes = true};
  using Basis = timed::Basis<1>;
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {{s.per_key("tension")}}; }
};

/// Quintic, C2 in time on any knots; on uniform knots with equal tensions it is Tan's quintic.
struct TimedC2 {
  static constexpr std::array parameters{tunable(timed::tension_1), tunable(timed::tension_2)};
  static constexpr FamilyInfo info{.name = "timed-c2",
                                   .title = "Local quintic spline, C2 in time",
                                   .source = "orispline, docs/families/timed-c2.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural,
                                   .closes = true};
  using Basis = timed::Basis<2>;
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {{s.per_key("tension"), s.per_key("tension2")}}; }
};

/// Septic, C3 in time on any knots.
struct TimedC3 {
  static constexpr std::array parameters{tunable(timed::tension_1), tunable(timed::tension_2),
                                         tunable(timed::tension_3)};
  static constexpr FamilyInfo info{.name = "timed-c3",
                                   .title = "Local septic spline, C3 in time",
                                   .source = "orispline, docs/families/timed-c3.md",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 3,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural,
                                   .closes = true};
  using Basis = timed::Basis<3>;
  [[nodiscard]] static Basis basis(const FamilySettings& s) {
    return {{s.per_key("tension"), s.per_key("tension2"), s.per_key("tension3")}};
  }
};

/// Degree 6, C3 in time on any knots, with one free tension; on uniform knots with τ = 6β it is the 6th-degree spline.
///
/// Second derivatives at a key are chosen so that both septic terms vanish; the third ones follow and need not be
/// formed.
struct TimedSextic {
  static constexpr std::array parameters{tunable(timed::tension_1)};
  static constexpr FamilyInfo info{.name = "timed-sextic",
                                   .title = "Local 6th-degree spline, C3 in time",
                                   .source = "orispline, docs/families/timed-sextic.md",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 3,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural,
                                   .closes = true};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 6;
    PerKey tension;

    [[nodiscard]] BernsteinRows<3, 7> coefficients(KnotSpan span) const noexcept {
      const double h = span.step();
      const auto l = scaled(at_key(span.i, span.previous_step(), h), h);
      const auto r = scaled(at_key(span.i + 1, h, span.next_step()), h);
      return {{{1.0, 1.0 + l.phi[0] / 6.0, 1.0 + l.phi[0] / 3.0 + l.phi[1] / 30.0, 1.0, 1.0, 1.0, 1.0},
               {0.0, l.psi[0] / 6.0, l.psi[0] / 3.0 + l.psi[1] / 30.0, 0.5, 1.0 - r.phi[0] / 3.0 + r.phi[1] / 30.0,
                1.0 - r.phi[0] / 6.0, 1.0},
               {0.0, 0.0, 0.0, 0.0, -r.psi[0] / 3.0 + r.psi[1] / 30.0, -r.psi[0] / 6.0, 0.0}}};
    }

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      return bernstein_sums(coefficients(span), span.normalised(t));
    }

    [[nodiscard]] KnotDerivatives<2> at_key(std::size_t key, double before, double after) const noexcept {
      const double tau = tension[key], both = before + after;
      const auto [phi1, psi1] = timed::first(before, after, tau);
      return {{phi1[0], -5.0 * (after - 2.0 * tau * (after - before)) / (before * before * both)},
              {psi1[0], 5.0 * (before - 2.0 * tau * (before - after)) / (after * after * both)}};
    }
  };
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {s.per_key("tension")}; }
};

}}}  // namespace orispline::families
