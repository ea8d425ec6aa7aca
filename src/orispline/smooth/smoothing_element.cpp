// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_element.hpp>

#include <cmath>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/chart_ends.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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
  const Jet<double, 1> coefficient(series::cotangent_defect_ratio(half.squaredNorm()));
  const Rates start = chart_end<P>({-half, coefficient}, -half, leaving, h);
  const Rates end = chart_end<P>({half, coefficient}, half, arriving, h);
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
  const Jet<double, 1> coefficient = inverse_coefficient(half.squaredNorm());
  const auto start = chart_end_slopes<P>({-half, coefficient}, -half, -0.5, leaving, h);
  const auto end = chart_end_slopes<P>({half, coefficient}, half, 0.5, arriving, h);
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

}}  // namespace orispline
