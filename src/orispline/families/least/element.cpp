// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least/element.hpp>

#include <array>
#include <cmath>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/least/expansion.hpp>
#include <orispline/math/gauss_legendre.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// The functions of the parts at u, as series in u.
std::array<Jet<double, 3>, least_parts> hermite_functions(double at) {
  const auto u = Jet<double, 3>::variable(at), v = Jet<double, 3>(1.0) - u;
  const auto u2 = u * u, u3 = u2 * u, v2 = v * v, v3 = v2 * v;
  return {u3 * (u2 * 6.0 - u * 15.0 + 10.0) - Jet<double, 3>(0.5), u * v3 * (u * 3.0 + 1.0), u2 * v3 * 0.5,
          u3 * v * (u * 3.0 - 4.0), u3 * v2 * 0.5};
}

LeastRule gauss_rule() {
  LeastRule points;
  const auto rule = gauss_legendre<LeastElement<LeastOf::acceleration>::gauss_points>();
  for (std::size_t g = 0; g < points.size(); ++g) {
    points[g].root_weight = std::sqrt(rule[g].weight);
    const auto functions = hermite_functions(rule[g].u);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t part = 0; part < least_parts; ++part)
        points[g].functions[k][part] = functions[part].derivative(k);
  }
  return points;
}

const LeastRule gauss = gauss_rule();

template <LeastOf F>
constexpr std::size_t order = least_order<F>;

template <LeastOf F, Number T>
using Derivatives = ChartSeries<order<F>, T>;

/// The integrand, in the local time: its root of a second has the power 1/2 - order.
template <LeastOf F, Number T>
Vector3<T> integrand(const Derivatives<F, T>& psi, const Eigen::Matrix3d& inertia) {
  constexpr int n = static_cast<int>(order<F>);
  Vector3<Jet<T, n>> path;
  double factorial = 1.0;
  for (std::size_t k = 0; k <= order<F>; ++k) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) path[axis].c[k] = psi[k][axis] * (1.0 / factorial);
    factorial *= static_cast<double>(k + 1);
  }
  const auto rate = chart_rate<T, n>(path);
  const auto derivative = [&rate](std::size_t k) -> Vector3<T> {
    return {rate.x().derivative(k), rate.y().derivative(k), rate.z().derivative(k)};
  };
  if constexpr (F == LeastOf::torque)
    return torque(MotionOver<T>{.angular_velocity = derivative(0), .angular_acceleration = derivative(1)}, inertia);
  else return derivative(order<F> - 1);
}

LeastParts<double> parts_of(const Eigen::Vector3d& step, const ChartEnd<3>& start, const ChartEnd<3>& end) {
  return {step, start.head<3>(), start.tail<3>(), end.head<3>(), end.tail<3>()};
}

/// The integrand at one point, and its derivatives by ψ and those of ψ that it has.
template <LeastOf F>
struct Slopes {
  Eigen::Vector3d value;
  std::array<Eigen::Matrix3d, order<F> + 1> by;

  Slopes(const Derivatives<F, double>& psi, const Eigen::Matrix3d& inertia) {
    if constexpr (F == LeastOf::acceleration) in_closed_form(psi[0], psi[1], psi[2]);
    else differentiate(psi, inertia);
  }

 private:
  /// α = J_r(p) a + N(p, v) term by term, with A, B the ratios of versine and sine defect and their slopes by |p|².
  void in_closed_form(const Eigen::Vector3d& p, const Eigen::Vector3d& v, const Eigen::Vector3d& a) {
    const auto x = Jet<double, 2>::variable(p.squaredNorm());
    const auto versine = series::versine_ratio(x), defect = series::sine_defect_ratio(x);
    const double A = versine.c[0], A1 = versine.c[1], A2 = 2.0 * versine.c[2];
    const double B = defect.c[0], B1 = defect.c[1], B2 = 2.0 * defect.c[2], s = p.dot(v);
    const Eigen::Matrix3d P = skew<double>(p), V = skew<double>(v), PP = P * P;
    const Eigen::Vector3d pv = p.cross(v), pa = p.cross(a), ppv = p.cross(pv), ppa = p.cross(pa), vpv = v.cross(pv);
    const Eigen::Matrix3d PV = skew<double>(pv), turning = B1 * PP - A1 * P;
    const Eigen::Vector3d changing = B1 * ppv - A1 * pv;
    by[2] = Eigen::Matrix3d::Identity() - A * P + B * PP;
    value = by[2] * a + 2.0 * s * changing + B * vpv;
    by[1] = 2.0 * changing * p.transpose() + 2.0 * s * turning + B * (V * P - PV);
    by[0] = 2.0 * (B1 * ppa - A1 * pa + 2.0 * s * (B2 * ppv - A2 * pv) + B1 * vpv) * p.transpose();
    by[0] += 2.0 * changing * v.transpose() + A * skew<double>(a) - B * (skew<double>(pa) + P * skew<double>(a));
    by[0] += 2.0 * s * (A1 * V - B1 * (PV + P * V)) - B * V * V;
  }

  void differentiate(const Derivatives<F, double>& psi, const Eigen::Matrix3d& inertia) {
    using D = Dual<3 * (order<F> + 1)>;
    Derivatives<F, D> variables;
    for (std::size_t k = 0; k < psi.size(); ++k)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        variables[k][axis] = D::variable(psi[k][axis], 3 * k + static_cast<std::size_t>(axis));
    const Vector3<D> result = integrand<F, D>(variables, inertia);
    for (Eigen::Index row = 0; row < 3; ++row) {
      value[row] = result[row].value;
      for (std::size_t k = 0; k < psi.size(); ++k)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          by[k](row, axis) = result[row].slope[3 * k + static_cast<std::size_t>(axis)];
    }
  }
};

}  // namespace

template <LeastOf F>
double least_scale(double h) {
  const double root = std::sqrt(h);
  return F == LeastOf::jerk ? 1.0 / (h * h * root) : 1.0 / (h * root);
}

const LeastRule& least_rule() { return gauss; }

template <LeastOf F>
typename LeastElement<F>::Residual LeastElement<F>::residual(const Eigen::Vector3d& step, const Rates& leaving,
                                                             const Rates& arriving, double h,
                                                             const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d half = 0.5 * step;
  const Jet<double, 1> coefficient(series::cotangent_defect_ratio(half.squaredNorm()));
  const auto values = parts_of(step, chart_end<3>({-half, coefficient}, -half, leaving, h),
                               chart_end<3>({half, coefficient}, half, arriving, h));
  const double scale = least_scale<F>(h);
  Residual e;
  for (std::size_t g = 0; g < gauss.size(); ++g)
    e.template segment<3>(3 * static_cast<Eigen::Index>(g)) =
        scale * gauss[g].root_weight * integrand<F, double>(series_at<F, double>(gauss[g], values), inertia);
  return e;
}

template <LeastOf F>
LeastExpansion<F> least_expansion(const Eigen::Vector3d& step, const ChartEnd<3>& leaving, const ChartEnd<3>& arriving,
                                  double h, const Eigen::Matrix3d& inertia) {
  constexpr int unknowns = LeastElement<F>::unknowns;
  const Eigen::Vector3d half = 0.5 * step;
  const Jet<double, 1> coefficient = inverse_coefficient(half.squaredNorm());
  LeastExpansion<F> e;
  e.start = chart_end_slopes<3>({-half, coefficient}, -half, -0.5, leaving, h);
  e.end = chart_end_slopes<3>({half, coefficient}, half, 0.5, arriving, h);
  e.values = parts_of(step, e.start.values, e.end.values);
  const double scale = least_scale<F>(h);
  for (std::size_t g = 0; g < gauss.size(); ++g) {
    const auto row = 3 * static_cast<Eigen::Index>(g);
    const double weight = scale * gauss[g].root_weight;
    const Slopes<F> slopes(series_at<F, double>(gauss[g], e.values), inertia);
    e.residual.template segment<3>(row) = weight * slopes.value;
    for (std::size_t part = 0; part < least_parts; ++part) {
      Eigen::Matrix3d sum = gauss[g].functions[0][part] * slopes.by[0];
      for (std::size_t k = 1; k < slopes.by.size(); ++k) sum += gauss[g].functions[k][part] * slopes.by[k];
      e.by_parts.template block<3, 3>(row, 3 * static_cast<Eigen::Index>(part)) = weight * sum;
    }
  }
  const auto by_start = e.by_parts.template middleCols<6>(3), by_end = e.by_parts.template rightCols<6>();
  e.by_step = e.by_parts.template leftCols<3>();
  e.by_step.noalias() += by_start * e.start.by_step;
  e.by_step.noalias() += by_end * e.end.by_step;
  const Eigen::Matrix3d step_by_turn = right_jacobian_inverse<double>(step);  // of the second; of the first -(this)ᵀ
  e.jacobian.template leftCols<3>().noalias() = -e.by_step * step_by_turn.transpose();
  e.jacobian.template middleCols<6>(3).noalias() = by_start * e.start.by_rates;
  e.jacobian.template middleCols<3>(unknowns).noalias() = e.by_step * step_by_turn;
  e.jacobian.template rightCols<6>().noalias() = by_end * e.end.by_rates;
  return e;
}

template <LeastOf F>
typename LeastElement<F>::Linearised LeastElement<F>::linearised(const Eigen::Vector3d& step, const Rates& leaving,
                                                                 const Rates& arriving, double h,
                                                                 const Eigen::Matrix3d& inertia) {
  const LeastExpansion<F> e = least_expansion<F>(step, leaving, arriving, h, inertia);
  return {e.residual, e.jacobian};
}

template double least_scale<LeastOf::acceleration>(double);
template double least_scale<LeastOf::torque>(double);
template double least_scale<LeastOf::jerk>(double);

template LeastExpansion<LeastOf::acceleration> least_expansion(const Eigen::Vector3d&, const ChartEnd<3>&,
                                                               const ChartEnd<3>&, double, const Eigen::Matrix3d&);
template LeastExpansion<LeastOf::torque> least_expansion(const Eigen::Vector3d&, const ChartEnd<3>&, const ChartEnd<3>&,
                                                         double, const Eigen::Matrix3d&);
template LeastExpansion<LeastOf::jerk> least_expansion(const Eigen::Vector3d&, const ChartEnd<3>&, const ChartEnd<3>&,
                                                       double, const Eigen::Matrix3d&);

template LeastElement<LeastOf::acceleration>::Residual LeastElement<LeastOf::acceleration>::residual(
    const Eigen::Vector3d&, const Rates&, const Rates&, double, const Eigen::Matrix3d&);
template LeastElement<LeastOf::torque>::Residual LeastElement<LeastOf::torque>::residual(const Eigen::Vector3d&,
                                                                                         const Rates&, const Rates&,
                                                                                         double,
                                                                                         const Eigen::Matrix3d&);
template LeastElement<LeastOf::jerk>::Residual LeastElement<LeastOf::jerk>::residual(const Eigen::Vector3d&,
                                                                                     const Rates&, const Rates&, double,
                                                                                     const Eigen::Matrix3d&);
template LeastElement<LeastOf::acceleration>::Linearised LeastElement<LeastOf::acceleration>::linearised(
    const Eigen::Vector3d&, const Rates&, const Rates&, double, const Eigen::Matrix3d&);
template LeastElement<LeastOf::torque>::Linearised LeastElement<LeastOf::torque>::linearised(const Eigen::Vector3d&,
                                                                                             const Rates&, const Rates&,
                                                                                             double,
                                                                                             const Eigen::Matrix3d&);
template LeastElement<LeastOf::jerk>::Linearised LeastElement<LeastOf::jerk>::linearised(const Eigen::Vector3d&,
                                                                                         const Rates&, const Rates&,
                                                                                         double,
                                                                                         const Eigen::Matrix3d&);

}}}  // namespace orispline::families
