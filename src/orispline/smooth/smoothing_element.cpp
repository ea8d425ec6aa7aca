// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_element.hpp>

#include <cmath>

#include <orispline/curve/chart_curve.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

using Derivative = Jet<double, 1>;

/// J_r⁻¹(y) and how it changes with y.
class InverseJacobian {
 public:
  /// `coefficient`: cotangent_defect_ratio as a function of |y|².
  InverseJacobian(const Eigen::Vector3d& y, const Derivative& coefficient)
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

Derivative inverse_coefficient(double squared_angle) {
  return series::cotangent_defect_ratio(Derivative::variable(squared_angle));
}

/// What the chart's motion adds to α besides J_r ÿ: the α of exp(y(t)) where ÿ = 0.
template <Number T>
Vector3<T> transport(const Vector3<T>& y, const Vector3<T>& velocity) {
  Vector3<Jet<T, 2>> path;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    path[axis].c[0] = y[axis];
    path[axis].c[1] = velocity[axis];
  }
  const auto rate = chart_rate<T, 2>(path);
  return {rate.x().c[1], rate.y().c[1], rate.z().c[1]};
}

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

/// Derivatives of ψ at one end, of orders 1 … P-1 in the local time 0 … 1, stacked.
template <int P>
using EndValues = typename SmoothingElement<P>::Rates;

/// The same with their derivatives by φ and by the rates of the end.
template <int P>
struct EndSlopes {
  EndValues<P> values;
  Eigen::Matrix<double, 3 * (P - 1), 3> by_step;
  Eigen::Matrix<double, 3 * (P - 1), 3 * (P - 1)> by_rates;
};

template <int P>
EndValues<P> end_values(const InverseJacobian& inverse, const Eigen::Vector3d& y, const EndValues<P>& rates, double h) {
  const Eigen::Vector3d velocity = inverse.times(rates.template head<3>());
  if constexpr (P == 2) {
    return h * velocity;
  } else {
    EndValues<P> values;
    values << h * velocity, h * h * inverse.times(rates.template tail<3>() - transport<double>(y, velocity));
    return values;
  }
}

/// `side`: y = side φ.
template <int P>
EndSlopes<P> end_slopes(const InverseJacobian& inverse, const Eigen::Vector3d& y, double side,
                        const EndValues<P>& rates, double h) {
  EndSlopes<P> end;
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

const double root3 = std::sqrt(3.0), root5 = std::sqrt(5.0);

/// The Legendre moments of ψ^(P), from a step and from the derivatives of ψ at both ends; rows of 3, any columns.
template <int P, class Step, class Ends, class Moments>
void moments(const Step& step, const Ends& start, const Ends& end, double scale, Moments&& result) {
  if constexpr (P == 2) {
    result.template topRows<3>() = scale * (end - start);
    result.template bottomRows<3>() = (root3 * scale) * (end + start - 2.0 * step);
  } else {
    const auto v0 = start.template topRows<3>(), v1 = end.template topRows<3>();
    const auto a0 = start.template bottomRows<3>(), a1 = end.template bottomRows<3>();
    result.template topRows<3>() = scale * (a1 - a0);
    result.template middleRows<3>(3) = (root3 * scale) * (a1 + a0 - 2.0 * (v1 - v0));
    result.template bottomRows<3>() = (root5 * scale) * (a1 - a0 - 6.0 * (v1 + v0) + 12.0 * step);
  }
}

/// h^(1/2 - P): from the local time to seconds.
template <int P>
double scale_of(double h) {
  const double root = std::sqrt(h);
  return P == 2 ? 1.0 / (h * root) : 1.0 / (h * h * root);
}

}  // namespace

template <int P>
typename SmoothingElement<P>::Residual SmoothingElement<P>::residual(const Eigen::Vector3d& step, const Rates& leaving,
                                                                     const Rates& arriving, double h) {
  const Eigen::Vector3d half = 0.5 * step;
  const Derivative coefficient(series::cotangent_defect_ratio(half.squaredNorm()));
  const Rates start = end_values<P>({-half, coefficient}, -half, leaving, h);
  const Rates end = end_values<P>({half, coefficient}, half, arriving, h);
  Residual e;
  moments<P>(step, start, end, scale_of<P>(h), e);
  return e;
}

template <int P>
typename SmoothingElement<P>::Linearised SmoothingElement<P>::linearised(const Eigen::Vector3d& step,
                                                                         const Rates& leaving, const Rates& arriving,
                                                                         double h) {
  const Eigen::Vector3d half = 0.5 * step;
  const double scale = scale_of<P>(h);
  const Derivative coefficient = inverse_coefficient(half.squaredNorm());
  const auto start = end_slopes<P>({-half, coefficient}, -half, -0.5, leaving, h);
  const auto end = end_slopes<P>({half, coefficient}, half, 0.5, arriving, h);
  Linearised e;
  moments<P>(step, start.values, end.values, scale, e.residual);
  Eigen::Matrix<double, unknowns, 3> by_step;
  moments<P>(Eigen::Matrix3d::Identity(), start.by_step, end.by_step, scale, by_step);
  const Eigen::Matrix3d step_by_turn = right_jacobian_inverse<double>(step);  // of the second; of the first -(this)ᵀ
  using RateSlopes = Eigen::Matrix<double, unknowns - 3, unknowns - 3>;
  const Eigen::Matrix<double, 3, unknowns - 3> no_step = Eigen::Matrix<double, 3, unknowns - 3>::Zero();
  const RateSlopes no_slopes = RateSlopes::Zero();
  e.jacobian.template leftCols<3>().noalias() = -by_step * step_by_turn.transpose();
  moments<P>(no_step, start.by_rates, no_slopes, scale, e.jacobian.template middleCols<unknowns - 3>(3));
  e.jacobian.template middleCols<3>(unknowns).noalias() = by_step * step_by_turn;
  moments<P>(no_step, no_slopes, end.by_rates, scale, e.jacobian.template rightCols<unknowns - 3>());
  return e;
}

template struct SmoothingElement<2>;
template struct SmoothingElement<3>;

std::vector<Eigen::Vector3d> mean_accelerations(std::span<const double> times, std::span<const Eigen::Vector3d> steps,
                                                std::span<const Eigen::Vector3d> rates) {
  std::vector<Eigen::Vector3d> sums(times.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double h = times[i + 1] - times[i];
    const Eigen::Vector3d half = 0.5 * steps[i], slope = steps[i] / h;
    const Eigen::Vector3d v0 = right_jacobian_inverse<double>(-half) * rates[i];
    const Eigen::Vector3d v1 = right_jacobian_inverse<double>(half) * rates[i + 1];
    sums[i] += body_rates(-half, {v0, (6.0 * slope - 4.0 * v0 - 2.0 * v1) / h, Eigen::Vector3d::Zero()})[1];
    sums[i + 1] += body_rates(half, {v1, (-6.0 * slope + 2.0 * v0 + 4.0 * v1) / h, Eigen::Vector3d::Zero()})[1];
  }
  for (std::size_t i = 1; i + 1 < times.size(); ++i) sums[i] *= 0.5;
  return sums;
}

}  // namespace orispline::inline ORISPLINE_ABI
