// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/curve/refined_chart_curve.hpp>
#include <orispline/families/least_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// How much of a piece's energy is more than it need be, by its residual of the equations of Euler and Lagrange.
///
/// Between keys they say that the momentum P of the orientation is constant in the world frame: P = R ω″ for the
/// acceleration, whence ω‴ = ω″ × ω. What P changes by within a piece of h [s] tells how far it is from there.
[[nodiscard]] double excess_of(LeastOf of, const Eigen::Matrix3d& inertia, const ChartPiece<5>& piece, double h);

/// Twice as many pieces in the intervals whose excess counts beside the whole energy; empty where none does.
[[nodiscard]] std::vector<std::size_t> refined(const std::vector<std::size_t>& counts,
                                               const std::vector<double>& excesses, double energy);

}}}  // namespace orispline::families
