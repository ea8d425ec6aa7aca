// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chart_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The polynomial path with value p and the derivatives d so far, as jets in t.
template <std::size_t Orders>
Vector3<Jet<double, Orders>> taylor(const Eigen::Vector3d& p, const ChartDerivatives& d) {
  Vector3<Jet<double, Orders>> path;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    path[axis].c[0] = p[axis];
    double factorial = 1.0;
    for (std::size_t k = 1; k <= Orders; ++k) path[axis].c[k] = d[k - 1][axis] / (factorial *= static_cast<double>(k));
  }
  return path;
}

template <class Rate>
Eigen::Vector3d of_order(std::size_t k, const Rate& rate) {
  return {rate.x().derivative(k), rate.y().derivative(k), rate.z().derivative(k)};
}

/// What is to be added to a chart derivative of that order for the body rates to be as wanted, by those derivatives d
/// that are lower: the rate of order k is J_r p^(k+1) plus what they already give.
template <std::size_t Order>
Eigen::Vector3d missing(const Eigen::Vector3d& rate, const Eigen::Vector3d& p, const ChartDerivatives& d) {
  return rate - of_order(Order, chart_rate<double, Order + 1>(taylor<Order + 1>(p, d)));
}

}  // namespace

ChartAcceleration::ChartAcceleration(const Eigen::Vector3d& p) : p_(p), jacobian_(right_jacobian<double>(p)) {
  const Eigen::Matrix3d turning = skew<double>(p);
  const auto x = Jet<double, 1>::variable(p.squaredNorm());
  const auto versine = series::versine_ratio(x), defect = series::sine_defect_ratio(x);
  changing_ = turning * (-2.0 * versine.c[1]) + turning * turning * (2.0 * defect.c[1]);
  defect_ = defect.c[0];
}

std::array<Eigen::Vector3d, 3> body_rates(const Eigen::Vector3d& p, const ChartDerivatives& derivatives) {
  const auto rate = chart_rate<double, 3>(taylor<3>(p, derivatives));
  return {of_order(0, rate), of_order(1, rate), of_order(2, rate)};
}

template <std::size_t K>
ChartDerivatives chart_derivatives(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& rates) {
  const Eigen::Matrix3d inverse = right_jacobian_inverse<double>(p);
  ChartDerivatives d{inverse * rates[0], Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if constexpr (K > 1) d[1] = inverse * missing<1>(rates[1], p, d);
  if constexpr (K > 2) d[2] = inverse * missing<2>(rates[2], p, d);
  return d;
}

template ChartDerivatives chart_derivatives<1>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);
template ChartDerivatives chart_derivatives<2>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);
template ChartDerivatives chart_derivatives<3>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);

}}  // namespace orispline
