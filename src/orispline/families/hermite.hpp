// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Cumulative Bernstein polynomials: segment i has increments of its own, Degree·i … Degree·i + Degree - 1.
template <std::size_t Degree>
struct CumulativeBernsteinBasis {
  static constexpr std::size_t increments = Degree, stride = Degree;
  static constexpr int degree = static_cast<int>(Degree);
  template <Number T>
  [[nodiscard]] std::array<T, Degree> operator()(KnotSpan span, const T& t) const noexcept {
    return cumulative_bernstein_basis<Degree>(span.normalised(t));
  }
};

/// An orientation with the body rates ω, α, jerk that a curve shall have there.
struct KeyMotion {
  Eigen::Quaterniond orientation;
  std::array<Eigen::Vector3d, 3> rates;
};

/// The increments of degree 2K+1 from one key to the next, with the rates of orders 1…K of both. h is the duration [s].
///
/// At a segment's start the factor k has a derivative of order k and none below: the rate of order k fixes it, given
/// the factors before. At the end so do the last factors, given those after. The middle one closes the product.
template <std::size_t K>
[[nodiscard]] std::array<Eigen::Vector3d, 2 * K + 1> cumulative_hermite_increments(const KeyMotion& start,
                                                                                   const KeyMotion& end, double h) {
  constexpr std::size_t n = 2 * K + 1;
  using J = Jet<double, 3>;
  const auto at_start = cumulative_bernstein_basis<n>(J::variable(0.0));
  const auto at_end = cumulative_bernstein_basis<n>(J::variable(1.0));
  const auto missing = [](const KeyMotion& key, const Motion& so_far, std::size_t k, double power) -> Eigen::Vector3d {
    const std::array found{so_far.angular_velocity, so_far.angular_acceleration, so_far.angular_jerk};
    return power * key.rates[k] - found[k];
  };
  std::array<Eigen::Vector3d, n> increments;
  Motion leaving{.orientation = start.orientation}, arriving;  // in the local parameter
  Eigen::Quaterniond inner_start = start.orientation;
  double power = 1.0;
  for (std::size_t k = 0; k < K; ++k) {
    power *= h;
    increments[k] = missing(start, leaving, k, power) / at_start[k].derivative(k + 1);
    leaving = with_factor(leaving, increments[k], at_start[k]);
    inner_start = inner_start * exp<double>(increments[k]);

    const std::size_t m = n - 1 - k;
    increments[m] =
        to_world<double>(arriving.orientation, missing(end, arriving, k, power)) / at_end[m].derivative(k + 1);
    arriving = {};
    for (std::size_t j = m; j < n; ++j) arriving = with_factor(arriving, increments[j], at_end[j]);
  }
  increments[K] = increment<double>(inner_start, end.orientation * arriving.orientation.conjugate());
  return increments;
}

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
  /// In the form that is chosen. Errors (bad_data): rates that wind the curve beyond what doubles tell apart, and in
  /// the chart a step of a full turn.
  [[nodiscard]] static Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings);
  /// Space needs no chart, and the keys have no rates there.
  [[nodiscard]] static Expected<HermitePath<2 * K + 1>> path(const Keyframes& keys, const FamilySettings& settings);

  using Cumulative = CumulativeCurve<CumulativeBernsteinBasis<2 * K + 1>>;
  [[nodiscard]] static Expected<ChartCurve<2 * K + 1>> chart(const Keyframes& keys, const FamilySettings& settings);
  [[nodiscard]] static Expected<Cumulative> cumulative(const Keyframes& keys, const FamilySettings& settings);
};

extern template struct Hermite<1>;
extern template struct Hermite<2>;
extern template struct Hermite<3>;
using HermiteC1 = Hermite<1>;
using HermiteC2 = Hermite<2>;
using HermiteC3 = Hermite<3>;

}}}  // namespace orispline::families
