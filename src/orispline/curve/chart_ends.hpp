// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/chart_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// J_r⁻¹(y) and how it changes with y.
class InverseJacobian {
 public:
  /// `coefficient`: cotangent_defect_ratio as a function of |y|²; its slope is for by_vector() alone.
  InverseJacobian(const Eigen::Vector3d& y, const Jet<double, 1>& coefficient)
      : y_(y), c_(coefficient.c[0]), slope_(coefficient.c[1]) {}

  [[nodiscard]] Eigen::Matrix3d matrix() const { return jacobian::rodrigues<double>(y_, 0.5, c_); }

  [[nodiscard]] Eigen::Vector3d times(const Eigen::Vector3d& w) const {
    const Eigen::Vector3d turn = y_.cross(w);
    return w + 0.5 * turn + c_ * y_.cross(turn);
  }

  /// ∂(J_r⁻¹(y) w)/∂y
  [[nodiscard]] Eigen::Matrix3d by_vector(const Eigen::Vector3d& w) const {
    Eigen::Matrix3d d = -0.5 * skew<double>(w);
    d += (c_ * y_) * w.transpose();
    d += (2.0 * slope_ * y_.cross(y_.cross(w)) - 2.0 * c_ * w) * y_.transpose();
    d.diagonal().array() += c_ * y_.dot(w);
    return d;
  }

 private:
  Eigen::Vector3d y_;
  double c_, slope_;
};

/// For InverseJacobian: the coefficient at |y|² with its slope.
[[nodiscard]] inline Jet<double, 1> inverse_coefficient(double squared_angle) {
  return series::cotangent_defect_ratio(Jet<double, 1>::variable(squared_angle));
}

/// What the chart's motion adds to α besides J_r ÿ: the α of exp(y(t)) where ÿ = 0.
template <Number T>
[[nodiscard]] Vector3<T> transport(const Vector3<T>& y, const Vector3<T>& velocity) {
  Vector3<Jet<T, 2>> path;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    path[axis].c[0] = y[axis];
    path[axis].c[1] = velocity[axis];
  }
  const auto rate = chart_rate<T, 2>(path);
  return {rate.x().c[1], rate.y().c[1], rate.z().c[1]};
}

/// Body rates at an end of a segment, ω and for P = 3 also α, and in the same form what they make of the path ψ in the
/// chart: its derivatives of orders 1 … P-1 in the local time 0 … 1, stacked.
template <int P>
using ChartEnd = Eigen::Matrix<double, 3 * (P - 1), 1>;

/// What the rates at an end make of the path in the chart, with their derivatives by φ and by the rates of the end.
template <int P>
struct ChartEndSlopes {
  ChartEnd<P> values;
  Eigen::Matrix<double, 3 * (P - 1), 3> by_step;
  Eigen::Matrix<double, 3 * (P - 1), 3 * (P - 1)> by_rates;
};

/// At ψ = y, of a segment that takes h [s].
template <int P>
[[nodiscard]] ChartEnd<P> chart_end(const InverseJacobian& inverse, const Eigen::Vector3d& y, const ChartEnd<P>& rates,
                                    double h);

/// `side`: y = side φ.
template <int P>
[[nodiscard]] ChartEndSlopes<P> chart_end_slopes(const InverseJacobian& inverse, const Eigen::Vector3d& y, double side,
                                                 const ChartEnd<P>& rates, double h);

}}  // namespace orispline
