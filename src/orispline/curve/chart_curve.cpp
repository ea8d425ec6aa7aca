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

/// What exp(p) and the change of chart of ω and α have of θ = |p| alone: it is the same at p and -p.
struct ChartSeries {
  double cosine, sinc;          // cos(θ/2) and sin(θ/2)/(θ/2), of which half the square is (1 - cos θ)/θ²
  double sinc_slope;            // by θ²
  double defect, defect_slope;  // (θ - sin θ)/θ³, and its derivative by θ²
  double inverse;               // (1 - (θ/2) cot(θ/2))/θ²

  explicit ChartSeries(const Eigen::Vector3d& p) {
    const auto x = Jet<double, 1>::variable(p.squaredNorm());
    const auto quarter = x * 0.25, half_sinc = series::sinc_sqrt(quarter), sine_defect = series::sine_defect_ratio(x);
    cosine = series::cos_sqrt(quarter.c[0]);
    sinc = half_sinc.c[0];
    sinc_slope = half_sinc.c[1];
    defect = sine_defect.c[0];
    defect_slope = sine_defect.c[1];
    inverse = series::cotangent_defect_ratio(x.c[0]);
  }
};

/// The α of exp(p(t)) where p̈ = 0, as in chart_rate().
Eigen::Vector3d drift(const ChartSeries& series, const Eigen::Vector3d& p, const Eigen::Vector3d& velocity) {
  const Eigen::Vector3d turn = p.cross(velocity);
  const double square_rate = 2.0 * p.dot(velocity);
  return p.cross(turn) * (series.defect_slope * square_rate) + velocity.cross(turn) * series.defect -
         turn * (series.sinc * (series.sinc_slope * square_rate));
}

/// The derivatives of orders 1 and 2 that give ω and α.
ChartDerivatives first_two(const ChartSeries& series, const Eigen::Vector3d& p,
                           const std::array<Eigen::Vector3d, 3>& rates) {
  const auto through_inverse = [&](const Eigen::Vector3d& rate) -> Eigen::Vector3d {
    const Eigen::Vector3d turn = p.cross(rate);
    return rate + 0.5 * turn + series.inverse * p.cross(turn);
  };
  const Eigen::Vector3d velocity = through_inverse(rates[0]);
  return {velocity, through_inverse(rates[1] - drift(series, p, velocity)), Eigen::Vector3d::Zero()};
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
  if constexpr (K == 1)
    return {right_jacobian_inverse<double>(p) * rates[0], Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  ChartDerivatives d = first_two(ChartSeries(p), p, rates);
  if constexpr (K > 2) d[2] = right_jacobian_inverse<double>(p) * missing<2>(rates[2], p, d);
  return d;
}

template ChartDerivatives chart_derivatives<1>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);
template ChartDerivatives chart_derivatives<2>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);
template ChartDerivatives chart_derivatives<3>(const Eigen::Vector3d&, const std::array<Eigen::Vector3d, 3>&);

ChartPiece<5> hermite_piece_about_middle(const Eigen::Quaterniond& start, const Eigen::Vector3d& step,
                                         const std::array<Eigen::Vector3d, 3>& leaving,
                                         const std::array<Eigen::Vector3d, 3>& arriving, double h) {
  const Eigen::Vector3d half = 0.5 * step, before = -half;
  const ChartSeries series(half);
  const Eigen::Vector3d axis = 0.5 * series.sinc * half;
  const Eigen::Quaterniond middle = start * Eigen::Quaterniond(series.cosine, axis.x(), axis.y(), axis.z());
  return chart_piece<2>(middle, before, half, first_two(series, before, leaving), first_two(series, half, arriving), h);
}

}}  // namespace orispline
