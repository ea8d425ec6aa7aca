// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chart_ends.hpp>

#include <array>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Derivative = Jet<double, 1>;

/// ∂transport/∂y and ∂transport/∂velocity
std::array<Eigen::Matrix3d, 2> transport_slopes(const Eigen::Vector3d& y, const Eigen::Vector3d& velocity) {
  std::array<Eigen::Matrix3d, 2> slopes;
  for (std::size_t argument = 0; argument < 2; ++argument)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::array arguments{constant<Derivative>(y), constant<Derivative>(velocity)};
      arguments[argument][axis].c[1] = 1.0;
      const auto result = transport<Derivative>(arguments[0], arguments[1]);
      for (Eigen::Index row = 0; row < 3; ++row) slopes[argument](row, axis) = result[row].c[1];
    }
  return slopes;
}

}  // namespace

template <int P>
ChartEnd<P> chart_end(const InverseJacobian& inverse, const Eigen::Vector3d& y, const ChartEnd<P>& rates, double h) {
  const Eigen::Vector3d velocity = inverse.times(rates.template head<3>());
  if constexpr (P == 2) {
    return h * velocity;
  } else {
    ChartEnd<P> values;
    values << h * velocity, h * h * inverse.times(rates.template tail<3>() - transport<double>(y, velocity));
    return values;
  }
}

template <int P>
ChartEndSlopes<P> chart_end_slopes(const InverseJacobian& inverse, const Eigen::Vector3d& y, double side,
                                   const ChartEnd<P>& rates, double h) {
  ChartEndSlopes<P> end;
  const Eigen::Matrix3d matrix = inverse.matrix();
  const Eigen::Vector3d omega = rates.template head<3>();
  if constexpr (P == 2) {
    end.values = h * (matrix * omega);
    end.by_step = (side * h) * inverse.by_vector(omega);
    end.by_rates = h * matrix;
  } else {
    const Eigen::Vector3d velocity = matrix * omega;
    const Eigen::Vector3d rest = rates.template tail<3>() - transport<double>(y, velocity);
    const Eigen::Matrix3d velocity_by_y = inverse.by_vector(omega);
    const auto [by_y, by_velocity] = transport_slopes(y, velocity);
    end.values << h * velocity, h * h * (matrix * rest);
    end.by_step << (side * h) * velocity_by_y,
        (side * h * h) * (inverse.by_vector(rest) - matrix * (by_y + by_velocity * velocity_by_y));
    end.by_rates << h * matrix, Eigen::Matrix3d::Zero(), (-h * h) * (matrix * by_velocity * matrix), h * h * matrix;
  }
  return end;
}

template ChartEnd<2> chart_end<2>(const InverseJacobian&, const Eigen::Vector3d&, const ChartEnd<2>&, double);
template ChartEndSlopes<2> chart_end_slopes<2>(const InverseJacobian&, const Eigen::Vector3d&, double,
                                               const ChartEnd<2>&, double);

template ChartEnd<3> chart_end<3>(const InverseJacobian&, const Eigen::Vector3d&, const ChartEnd<3>&, double);
template ChartEndSlopes<3> chart_end_slopes<3>(const InverseJacobian&, const Eigen::Vector3d&, double,
                                               const ChartEnd<3>&, double);

}}  // namespace orispline
