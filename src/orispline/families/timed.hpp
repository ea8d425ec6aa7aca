// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/control_points.hpp>
#include <orispline/math/bernstein.hpp>

// Local interpolating splines that are C1, C2, C3 in time on any knots.
//
// Near a key both neighbouring segments equal Q exp(a f) exp(b g) with the increments a before and b after it, and
// f = 1 + φ₁τ + φ₂τ²/2 + …, g = ψ₁τ + …: the derivatives φ, ψ belong to the key, not to a segment, so the curve is C^k
// in time whatever they are. Their values below make the parabola through three keys (φ₁, ψ₁, φ₂, ψ₂ with tensions ½,
// 1). Derivation: docs/families/timed.md.

namespace orispline::families {

namespace timed {

/// Derivatives in time of the two factors beside a key, orders 1…K: of the increment before it and of the one after it.
template <std::size_t K>
struct KnotDerivatives {
  std::array<double, K> phi, psi;
};

/// The same in the local parameter of a segment of length h: order m times h^m.
template <std::size_t K>
[[nodiscard]] KnotDerivatives<K> scaled(KnotDerivatives<K> d, double h) noexcept {
  double power = 1.0;
  for (std::size_t m = 0; m < K; ++m) {
    power *= h;
    d.phi[m] *= power;
    d.psi[m] *= power;
  }
  return d;
}

/// φ₁, ψ₁ with tension τ₁; ½ is the tangent of the parabola through three keys. `before`, `after`: the knot steps [s].
[[nodiscard]] inline KnotDerivatives<1> first(double before, double after, double tension) noexcept {
  const double both = before + after;
  return {{2.0 * tension * after / (before * both)}, {2.0 * tension * before / (after * both)}};
}

/// The cumulative blending functions of one segment in Bernstein form of degree 2K+1, from the knot derivatives at its
/// two ends in the local parameter.
template <std::size_t K>
[[nodiscard]] std::array<std::array<double, 2 * K + 2>, 3> blending(const KnotDerivatives<K>& left,
                                                                    const KnotDerivatives<K>& right) noexcept {
  // Bernstein coefficients that take the derivatives d at u = 0 (value apart): Taylor polynomial to Bernstein form.
  const auto rise = [](const std::array<double, K>& d) {
    constexpr std::size_t n = 2 * K + 1;
    std::array<double, K + 1> c{};
    for (std::size_t i = 1; i <= K; ++i) {
      double weight = 1.0;  // C(i, m) (n - m)!/n!
      for (std::size_t m = 1; m <= i; ++m) {
        weight *= static_cast<double>(i - m + 1) / (static_cast<double>(m) * static_cast<double>(n - m + 1));
        c[i] += weight * d[m - 1];
      }
    }
    return c;
  };
  // At u = 1 the odd orders change sign, for the coefficients run inwards.
  const auto fall = [&rise](std::array<double, K> d) {
    for (std::size_t m = 0; m < K; m += 2) d[m] = -d[m];
    return rise(d);
  };
  const auto phi = rise(left.phi), psi = rise(left.psi), phi_end = fall(right.phi), psi_end = fall(right.psi);
  std::array<std::array<double, 2 * K + 2>, 3> b{};
  for (std::size_t i = 0; i <= K; ++i) {
    const std::size_t j = 2 * K + 1 - i;
    b[0][i] = 1.0 + phi[i];
    b[0][j] = 1.0;
    b[1][i] = psi[i];
    b[1][j] = 1.0 + phi_end[i];
    b[2][j] = psi_end[i];
  }
  return b;
}

inline constexpr Parameter tension_1{"tension", 0.5, -100.0, 100.0};
inline constexpr Parameter tension_2{"tension2", 1.0, -100.0, 100.0};
inline constexpr Parameter tension_3{"tension3", 0.0, -100.0, 100.0};

/// Blending functions that are C^K in time.
template <std::size_t K>
struct Basis {
  static constexpr std::size_t increments = 3, stride = 1;
  static constexpr int degree = 2 * static_cast<int>(K) + 1;
  std::array<PerKey, K> tensions;

  template <Number T>
  [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
    const double before = span.previous_step(), h = span.step(), after = span.next_step();
    return bernstein_sums<3, 2 * K + 2>(
        blending<K>(scaled(at_key(span.i, before, h), h), scaled(at_key(span.i + 1, h, after), h)), span.normalised(t));
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
  static constexpr std::array parameters{timed::tension_1};
  static constexpr FamilyInfo info{.name = "timed-c1",
                                   .title = "Local cubic spline, C1 in time",
                                   .source = "orispline, docs/families/timed.md",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural};
  using Basis = timed::Basis<1>;
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {{s.per_key("tension")}}; }
};

/// Quintic, C2 in time on any knots; on uniform knots with equal tensions it is Tan's quintic.
struct TimedC2 {
  static constexpr std::array parameters{timed::tension_1, timed::tension_2};
  static constexpr FamilyInfo info{.name = "timed-c2",
                                   .title = "Local quintic spline, C2 in time",
                                   .source = "orispline, docs/families/timed.md",
                                   .continuity_uniform = 2,
                                   .continuity_uneven = 2,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural};
  using Basis = timed::Basis<2>;
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {{s.per_key("tension"), s.per_key("tension2")}}; }
};

/// Septic, C3 in time on any knots.
struct TimedC3 {
  static constexpr std::array parameters{timed::tension_1, timed::tension_2, timed::tension_3};
  static constexpr FamilyInfo info{.name = "timed-c3",
                                   .title = "Local septic spline, C3 in time",
                                   .source = "orispline, docs/families/timed.md",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 3,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural};
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
  static constexpr std::array parameters{timed::tension_1};
  static constexpr FamilyInfo info{.name = "timed-sextic",
                                   .title = "Local 6th-degree spline, C3 in time",
                                   .source = "orispline, docs/families/timed.md",
                                   .continuity_uniform = 3,
                                   .continuity_uneven = 3,
                                   .keeps_constant_rate_uniform = true,
                                   .keeps_constant_rate_uneven = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = four_key_ends_natural};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 6;
    PerKey tension;

    template <Number T>
    [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
      const double h = span.step();
      const auto l = timed::scaled(at_key(span.i, span.previous_step(), h), h);
      const auto r = timed::scaled(at_key(span.i + 1, h, span.next_step()), h);
      return bernstein_sums<3, 7>(
          {{{1.0, 1.0 + l.phi[0] / 6.0, 1.0 + l.phi[0] / 3.0 + l.phi[1] / 30.0, 1.0, 1.0, 1.0, 1.0},
            {0.0, l.psi[0] / 6.0, l.psi[0] / 3.0 + l.psi[1] / 30.0, 0.5, 1.0 - r.phi[0] / 3.0 + r.phi[1] / 30.0,
             1.0 - r.phi[0] / 6.0, 1.0},
            {0.0, 0.0, 0.0, 0.0, -r.psi[0] / 3.0 + r.psi[1] / 30.0, -r.psi[0] / 6.0, 0.0}}},
          span.normalised(t));
    }

    [[nodiscard]] timed::KnotDerivatives<2> at_key(std::size_t key, double before, double after) const noexcept {
      const double tau = tension[key], both = before + after;
      const auto [phi1, psi1] = timed::first(before, after, tau);
      return {{phi1[0], -5.0 * (after - 2.0 * tau * (after - before)) / (before * before * both)},
              {psi1[0], 5.0 * (before - 2.0 * tau * (before - after)) / (after * after * both)}};
    }
  };
  [[nodiscard]] static Basis basis(const FamilySettings& s) { return {s.per_key("tension")}; }
};

}  // namespace orispline::families
