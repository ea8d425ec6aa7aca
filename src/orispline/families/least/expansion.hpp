// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/curve/chart_ends.hpp>
#include <orispline/families/least/element.hpp>

// What both orders of derivatives of an element are made of.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// What ψ is made of, each with a function of the local time u: φ, then ψ' and ψ'' at the start, then at the end.
inline constexpr std::size_t least_parts = 5;

template <Number T>
using LeastParts = std::array<Vector3<T>, least_parts>;

/// A point of the rule.
struct LeastPoint {
  double root_weight;
  std::array<std::array<double, least_parts>, 4> functions;  ///< of the parts, their derivatives of orders 0…3
};

using LeastRule = std::array<LeastPoint, LeastElement<LeastOf::acceleration>::gauss_points>;
[[nodiscard]] const LeastRule& least_rule();

/// Of the highest derivative of ψ in the integrand.
template <LeastOf F>
inline constexpr std::size_t least_order = F == LeastOf::jerk ? 3 : 2;

/// ψ and its derivatives at one u, up to that order.
template <std::size_t Order, Number T>
using ChartSeries = std::array<Vector3<T>, Order + 1>;

template <LeastOf F, Number T>
[[nodiscard]] ChartSeries<least_order<F>, T> series_at(const LeastPoint& point, const LeastParts<T>& values) {
  ChartSeries<least_order<F>, T> psi;
  for (std::size_t k = 0; k < psi.size(); ++k) {
    psi[k].setConstant(T(0.0));
    for (std::size_t part = 0; part < least_parts; ++part)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        psi[k][axis] += values[part][axis] * Plain<T>(point.functions[k][part]);
  }
  return psi;
}

/// An element linearised, and the steps of that: the ends by φ and their rates, the residual by the parts and by φ.
template <LeastOf F>
struct LeastExpansion {
  LeastParts<double> values;
  ChartEndSlopes<3> start, end;
  typename LeastElement<F>::Residual residual;
  Eigen::Matrix<double, LeastElement<F>::rows, 3 * least_parts> by_parts;
  Eigen::Matrix<double, LeastElement<F>::rows, 3> by_step;
  typename LeastElement<F>::Jacobian jacobian;
};

template <LeastOf F>
[[nodiscard]] LeastExpansion<F> least_expansion(const Eigen::Vector3d& step, const ChartEnd<3>& leaving,
                                                const ChartEnd<3>& arriving, double h, const Eigen::Matrix3d& inertia);

/// What the integrand in the local time has to be multiplied with for an element of h [s].
template <LeastOf F>
[[nodiscard]] double least_scale(double h);

}}}  // namespace orispline::families
