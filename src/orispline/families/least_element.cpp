// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least_element.hpp>

#include <array>
#include <cmath>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/torque.hpp>
#include <orispline/math/gauss_legendre.hpp>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

/// What ψ is made of, each with a function of the local time u: φ, then ψ' and ψ'' at the start, then at the end.
constexpr std::size_t parts = 5;

/// The functions of the parts at u, as series in u.
std::array<Jet<double, 3>, parts> hermite_functions(double at) {
  const auto u = Jet<double, 3>::variable(at), v = Jet<double, 3>(1.0) - u;
  const auto u2 = u * u, u3 = u2 * u, v2 = v * v, v3 = v2 * v;
  return {u3 * (u2 * 6.0 - u * 15.0 + 10.0) - Jet<double, 3>(0.5), u * v3 * (u * 3.0 + 1.0), u2 * v3 * 0.5,
          u3 * v * (u * 3.0 - 4.0), u3 * v2 * 0.5};
}

struct GaussPoint {
  double root_weight;
  std::array<std::array<double, parts>, 4> functions;  ///< derivatives of orders 0…3
};

template <std::size_t N>
std::array<GaussPoint, N> gauss_rule() {
  std::array<GaussPoint, N> points;
  const auto rule = gauss_legendre<N>();
  for (std::size_t g = 0; g < N; ++g) {
    points[g].root_weight = std::sqrt(rule[g].weight);
    const auto functions = hermite_functions(rule[g].u);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t part = 0; part < parts; ++part) points[g].functions[k][part] = functions[part].derivative(k);
  }
  return points;
}

const auto gauss = gauss_rule<LeastElement<LeastOf::acceleration>::gauss_points>();

template <LeastOf F>
constexpr std::size_t order = F == LeastOf::jerk ? 3 : 2;  ///< of the highest derivative of ψ in the integrand

/// ψ and its derivatives at one u.
template <LeastOf F, Number T>
using Derivatives = std::array<Vector3<T>, order<F> + 1>;

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

template <Number T>
using Parts = std::array<Vector3<T>, parts>;

template <LeastOf F, Number T>
Derivatives<F, T> derivatives_at(const GaussPoint& point, const Parts<T>& values) {
  Derivatives<F, T> psi;
  for (std::size_t k = 0; k <= order<F>; ++k) {
    psi[k].setConstant(T(0.0));
    for (std::size_t part = 0; part < parts; ++part)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        psi[k][axis] += values[part][axis] * Plain<T>(point.functions[k][part]);
  }
  return psi;
}

template <LeastOf F>
double scale_of(double h) {
  const double root = std::sqrt(h);
  return F == LeastOf::jerk ? 1.0 / (h * h * root) : 1.0 / (h * root);
}

Parts<double> parts_of(const Eigen::Vector3d& step, const ChartEnd<3>& start, const ChartEnd<3>& end) {
  return {step, start.head<3>(), start.tail<3>(), end.head<3>(), end.tail<3>()};
}

/// Over any numbers what chart_end() is over doubles: ψ' and ψ'' at y.
template <Number T>
std::array<Vector3<T>, 2> end_over(const Vector3<T>& y, const Vector3<T>& omega, const Vector3<T>& alpha, double h) {
  const Matrix3<T> inverse = right_jacobian_inverse<T>(y);
  const Vector3<T> velocity = inverse * omega, rest = alpha - transport<T>(y, velocity);
  const Vector3<T> acceleration = inverse * rest;
  return {velocity * T(h), acceleration * T(h * h)};
}

/// Two variables at once of the eighteen: each in the duals, one of them in the jet as well.
using Twice = Jet<Dual<18>, 1>;

/// Half the energy as a function of the unknowns, about turns of zero.
template <LeastOf F>
Twice half_energy(const Eigen::Quaterniond& step, const std::array<Twice, 18>& x, double h,
                  const Eigen::Matrix3d& inertia) {
  const auto vector = [&x](std::size_t first) -> Vector3<Twice> { return {x[first], x[first + 1], x[first + 2]}; };
  const Vector3<Twice> phi = log<Twice>(exp<Twice>(-vector(0)) * constant<Twice>(step) * exp<Twice>(vector(9)));
  const Vector3<Twice> half = phi * Twice(0.5);
  const auto start = end_over<Twice>(-half, vector(3), vector(6), h),
             end = end_over<Twice>(half, vector(12), vector(15), h);
  const Parts<Twice> values{phi, start[0], start[1], end[0], end[1]};
  Twice sum(0.0);
  for (const GaussPoint& point : gauss) {
    const Vector3<Twice> f = integrand<F, Twice>(derivatives_at<F, Twice>(point, values), inertia);
    sum += f.squaredNorm() * (0.5 * point.root_weight * point.root_weight);
  }
  return sum * (scale_of<F>(h) * scale_of<F>(h));
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
typename LeastElement<F>::Residual LeastElement<F>::residual(const Eigen::Vector3d& step, const Rates& leaving,
                                                             const Rates& arriving, double h,
                                                             const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d half = 0.5 * step;
  const Jet<double, 1> coefficient(series::cotangent_defect_ratio(half.squaredNorm()));
  const auto values = parts_of(step, chart_end<3>({-half, coefficient}, -half, leaving, h),
                               chart_end<3>({half, coefficient}, half, arriving, h));
  const double scale = scale_of<F>(h);
  Residual e;
  for (std::size_t g = 0; g < gauss.size(); ++g)
    e.template segment<3>(3 * static_cast<Eigen::Index>(g)) =
        scale * gauss[g].root_weight * integrand<F, double>(derivatives_at<F, double>(gauss[g], values), inertia);
  return e;
}

template <LeastOf F>
typename LeastElement<F>::Linearised LeastElement<F>::linearised(const Eigen::Vector3d& step, const Rates& leaving,
                                                                 const Rates& arriving, double h,
                                                                 const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d half = 0.5 * step;
  const Jet<double, 1> coefficient = inverse_coefficient(half.squaredNorm());
  const auto start = chart_end_slopes<3>({-half, coefficient}, -half, -0.5, leaving, h);
  const auto end = chart_end_slopes<3>({half, coefficient}, half, 0.5, arriving, h);
  const auto values = parts_of(step, start.values, end.values);
  const double scale = scale_of<F>(h);
  Linearised e;
  Eigen::Matrix<double, rows, 3 * parts> by_parts;
  for (std::size_t g = 0; g < gauss.size(); ++g) {
    const auto row = 3 * static_cast<Eigen::Index>(g);
    const double weight = scale * gauss[g].root_weight;
    const Slopes<F> slopes(derivatives_at<F, double>(gauss[g], values), inertia);
    e.residual.template segment<3>(row) = weight * slopes.value;
    for (std::size_t part = 0; part < parts; ++part) {
      Eigen::Matrix3d sum = gauss[g].functions[0][part] * slopes.by[0];
      for (std::size_t k = 1; k < slopes.by.size(); ++k) sum += gauss[g].functions[k][part] * slopes.by[k];
      by_parts.template block<3, 3>(row, 3 * static_cast<Eigen::Index>(part)) = weight * sum;
    }
  }
  const auto by_start = by_parts.template middleCols<6>(3), by_end = by_parts.template rightCols<6>();
  Eigen::Matrix<double, rows, 3> by_step = by_parts.template leftCols<3>();
  by_step.noalias() += by_start * start.by_step;
  by_step.noalias() += by_end * end.by_step;
  const Eigen::Matrix3d step_by_turn = right_jacobian_inverse<double>(step);  // of the second; of the first -(this)ᵀ
  e.jacobian.template leftCols<3>().noalias() = -by_step * step_by_turn.transpose();
  e.jacobian.template middleCols<6>(3).noalias() = by_start * start.by_rates;
  e.jacobian.template middleCols<3>(unknowns).noalias() = by_step * step_by_turn;
  e.jacobian.template rightCols<6>().noalias() = by_end * end.by_rates;
  return e;
}

template <LeastOf F>
typename LeastElement<F>::Curved LeastElement<F>::curved(const Eigen::Vector3d& step, const Rates& leaving,
                                                         const Rates& arriving, double h,
                                                         const Eigen::Matrix3d& inertia) {
  std::array<double, 18> values{};
  for (std::size_t k = 0; k < 6; ++k) {
    values[3 + k] = leaving[static_cast<Eigen::Index>(k)];
    values[12 + k] = arriving[static_cast<Eigen::Index>(k)];
  }
  const Eigen::Quaterniond between = exp<double>(step);
  Curved curved;
  for (std::size_t row = 0; row < 18; ++row) {
    std::array<Twice, 18> x;
    for (std::size_t k = 0; k < 18; ++k) x[k].c[0] = Dual<18>::variable(values[k], k);
    x[row].c[1] = Dual<18>(1.0);
    const Twice energy = half_energy<F>(between, x, h, inertia);
    const auto i = static_cast<Eigen::Index>(row);
    curved.gradient[i] = energy.c[1].value;
    for (std::size_t k = 0; k < 18; ++k) curved.hessian(i, static_cast<Eigen::Index>(k)) = energy.c[1].slope[k];
  }
  return curved;
}

template struct LeastElement<LeastOf::acceleration>;
template struct LeastElement<LeastOf::torque>;
template struct LeastElement<LeastOf::jerk>;

}  // namespace orispline::inline ORISPLINE_ABI::families
