// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chart_curve.hpp>

namespace orispline {
namespace {

/// The polynomial path with value p and the derivatives d so far, as jets in t.
Vector3<Jet<double, 3>> taylor(const Eigen::Vector3d& p, const ChartDerivatives& d) {
  Vector3<Jet<double, 3>> path;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    path[axis].c = {p[axis], d[0][axis], d[1][axis] / 2.0, d[2][axis] / 6.0};
  return path;
}

}  // namespace

std::array<Eigen::Vector3d, 3> body_rates(const Eigen::Vector3d& p, const ChartDerivatives& derivatives) {
  const auto rate = chart_rate<double, 3>(taylor(p, derivatives));
  const auto order = [&rate](std::size_t k) {
    return Eigen::Vector3d(rate.x().derivative(k), rate.y().derivative(k), rate.z().derivative(k));
  };
  return {order(0), order(1), order(2)};
}

ChartDerivatives chart_derivatives(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& rates) {
  const Eigen::Matrix3d inverse = right_jacobian_inverse<double>(p);
  ChartDerivatives d{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (std::size_t k = 0; k < d.size(); ++k) {
    // The rate of order k is J_r p^(k+1) plus what the lower derivatives already give.
    d[k] = inverse * (rates[k] - body_rates(p, d)[k]);
  }
  return d;
}

}  // namespace orispline
