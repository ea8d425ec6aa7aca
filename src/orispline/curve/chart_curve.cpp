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

ChartDerivatives chart_derivatives(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& rates) {
  const Eigen::Matrix3d inverse = right_jacobian_inverse<double>(p);
  ChartDerivatives d{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (std::size_t k = 0; k < d.size(); ++k) {
    // The rate of order k is J_r p^(k+1) plus what the lower derivatives already give.
    const auto known = chart_rate<double, 3>(taylor(p, d));
    const Eigen::Vector3d given(known.x().derivative(k), known.y().derivative(k), known.z().derivative(k));
    d[k] = inverse * (rates[k] - given);
  }
  return d;
}

}  // namespace orispline
