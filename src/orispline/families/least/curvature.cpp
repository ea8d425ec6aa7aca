// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least/expansion.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>

#include <orispline/math/jet.hpp>
#include <orispline/math/series.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// w·α + z·ω of the motion exp(ψ) for constant w and z, with its second derivatives by ψ, ψ' and ψ'', which are called
/// p, v and a.
///
/// It is a function of scalars. With A, B the ratios of versine and sine defect as functions of x = p², A', B' their
/// slopes and s = p·v:
///
///     A (-p·(a×w) - p·(v×z)) + A' (-2s p·(v×w)) + B' 2s ((w·p) s - (w·v) x) + w·a + z·v
///     + B ((w·p)(p·a + v²) - (w·v) s - (w·a) x + (z·p) s - (z·v) x)
template <Number T>
class LeastRateSum {
 public:
  LeastRateSum(const Vector3<T>& p, const Vector3<T>& v, const Vector3<T>& a, const Vector3<T>& w, const Vector3<T>& z)
      : p_(p), v_(v), a_(a), w_(w), z_(z) {
    const T x = p.squaredNorm(), s = p.dot(v), vv = v.squaredNorm(), pa = p.dot(a), one(1.0);
    const T wp = w.dot(p), wv = w.dot(v), wa = w.dot(a), zp = z.dot(p), zv = z.dot(v), pvw = p.dot(v.cross(w));
    const auto place = Jet<T, 3>::variable(x);
    const auto versine = series::versine_ratio(place), defect = series::sine_defect_ratio(place);
    slopes_.fill(T(0.0));
    curvature_.setConstant(T(0.0));
    slopes_[WA] = slopes_[ZV] = one;
    add(versine, 0, -p.dot(a.cross(w)) - p.dot(v.cross(z)), {{PAW, -one}, {PVZ, -one}}, {});
    add(versine, 1, s * pvw * -2.0, {{S, pvw * -2.0}, {PVW, s * -2.0}}, {{S, PVW, one * -2.0}});
    add(defect, 0, wp * (pa + vv) - wv * s - wa * x + zp * s - zv * x,
        {{WP, pa + vv}, {PA, wp}, {VV, wp}, {WV, -s}, {S, zp - wv}, {WA, -x}, {X, -wa - zv}, {ZP, s}, {ZV, -x}},
        {{WP, PA, one}, {WP, VV, one}, {WV, S, -one}, {WA, X, -one}, {ZP, S, one}, {ZV, X, -one}});
    add(defect, 1, s * (wp * s - wv * x) * 2.0,
        {{WP, s * s * 2.0}, {S, wp * s * 4.0 - wv * x * 2.0}, {WV, s * x * -2.0}, {X, s * wv * -2.0}},
        {{WP, S, s * 4.0}, {S, S, wp * 4.0}, {S, WV, x * -2.0}, {X, S, wv * -2.0}, {X, WV, s * -2.0}});
  }

  [[nodiscard]] Eigen::Matrix<T, 9, 9> curvature() const {
    const auto by = gradients();
    const Eigen::Matrix<T, scalars, 9> curved = curvature_ * by;
    Eigen::Matrix<T, 9, 9> sum = by.transpose() * curved;
    const auto add_block = [&sum](Eigen::Index row, Eigen::Index column, const T& diagonal, const Matrix3<T>& rest) {
      Matrix3<T> block = rest;
      for (Eigen::Index k = 0; k < 3; ++k) block(k, k) += diagonal;
      sum.template block<3, 3>(row, column) += block;
      if (row != column) sum.template block<3, 3>(column, row) += block.transpose();
    };
    const Matrix3<T> none = Matrix3<T>::Constant(T(0.0)), W = skew<T>(w_), Z = skew<T>(z_);
    add_block(0, 0, slopes_[X] * 2.0, none);
    add_block(3, 3, slopes_[VV] * 2.0, none);
    add_block(0, 3, slopes_[S], W * -slopes_[PVW] - Z * slopes_[PVZ]);
    add_block(0, 6, slopes_[PA], W * -slopes_[PAW]);
    return sum;
  }

 private:
  /// p², p·v, v², w·p, w·v, w·a, p·a, p·(a×w), p·(v×w), z·p, z·v, p·(v×z)
  enum Scalar : std::uint8_t { X, S, VV, WP, WV, WA, PA, PAW, PVW, ZP, ZV, PVZ };
  static constexpr int scalars = 12;
  struct Slope {
    Scalar by;
    T value;
  };
  struct Second {
    Scalar by, and_by;
    T value;
  };

  /// Adds a function of x, differentiated so many times, times a polynomial that has these slopes.
  void add(const Jet<T, 3>& function, std::size_t order, const T& value, std::initializer_list<Slope> slopes,
           std::initializer_list<Second> seconds) {
    const T f = function.derivative(order), f1 = function.derivative(order + 1);
    slopes_[X] += f1 * value;
    curvature_(X, X) += function.derivative(order + 2) * value;
    for (const Slope& slope : slopes) {
      slopes_[slope.by] += f * slope.value;
      curvature_(X, slope.by) += f1 * slope.value;
      curvature_(slope.by, X) += f1 * slope.value;
    }
    for (const Second& second : seconds) {
      curvature_(second.by, second.and_by) += f * second.value;
      if (second.by != second.and_by) curvature_(second.and_by, second.by) += f * second.value;
    }
  }

  /// Of the scalars, a row for each.
  [[nodiscard]] Eigen::Matrix<T, scalars, 9> gradients() const {
    Eigen::Matrix<T, scalars, 9> by = Eigen::Matrix<T, scalars, 9>::Constant(T(0.0));
    const auto set = [&by](Scalar scalar, Eigen::Index first, const Vector3<T>& slope) {
      by.template block<1, 3>(scalar, first) = slope.transpose();
    };
    set(X, 0, p_ * T(2.0)), set(S, 0, v_), set(S, 3, p_), set(VV, 3, v_ * T(2.0)), set(PA, 0, a_), set(PA, 6, p_);
    set(WP, 0, w_), set(WV, 3, w_), set(WA, 6, w_), set(ZP, 0, z_), set(ZV, 3, z_);
    set(PAW, 0, a_.cross(w_)), set(PAW, 6, w_.cross(p_)), set(PVW, 0, v_.cross(w_)), set(PVW, 3, w_.cross(p_));
    set(PVZ, 0, v_.cross(z_)), set(PVZ, 3, z_.cross(p_));
    return by;
  }

  Vector3<T> p_, v_, a_, w_, z_;
  std::array<T, scalars> slopes_;
  Eigen::Matrix<T, scalars, scalars> curvature_;
};

template <LeastOf F>
using Square =
    Eigen::Matrix<double, 3 * (static_cast<int>(least_order<F>) + 1), 3 * (static_cast<int>(least_order<F>) + 1)>;

/// ω of exp(ψ) and its derivatives by ψ and ψ'.
struct RateSlopes {
  Eigen::Vector3d value;
  Eigen::Matrix<double, 3, 6> by;

  RateSlopes(const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
    const auto x = Jet<double, 1>::variable(p.squaredNorm());
    const auto versine = series::versine_ratio(x), defect = series::sine_defect_ratio(x);
    const Eigen::Matrix3d P = skew<double>(p);
    const Eigen::Vector3d turn = p.cross(v), twice = p.cross(turn);
    by.rightCols<3>() = Eigen::Matrix3d::Identity() - versine.c[0] * P + defect.c[0] * P * P;
    value = by.rightCols<3>() * v;
    by.leftCols<3>() =
        versine.c[0] * skew<double>(v) + 2.0 * (defect.c[1] * twice - versine.c[1] * turn) * p.transpose();
    by.leftCols<3>() += defect.c[0] * (p * v.transpose() - 2.0 * v * p.transpose());
    by.leftCols<3>().diagonal().array() += defect.c[0] * p.dot(v);
  }
};

/// The second derivatives of w·f at one point, f the jerk: it is what α changes by as (ψ, ψ', ψ'') does along u.
Square<LeastOf::jerk> curvature_of_jerk(const ChartSeries<3, double>& psi, const Eigen::Vector3d& w) {
  using S = Jet<double, 1>;
  std::array<Vector3<S>, 3> along;
  for (std::size_t k = 0; k < 3; ++k)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      along[k][axis].c[0] = psi[k][axis];
      along[k][axis].c[1] = psi[k + 1][axis];
    }
  const Vector3<S> none = Vector3<S>::Constant(S(0.0));
  const auto of_alpha = LeastRateSum<S>(along[0], along[1], along[2], constant<S>(w), none).curvature();
  Square<LeastOf::jerk> sum = Square<LeastOf::jerk>::Zero();
  for (Eigen::Index i = 0; i < 9; ++i)
    for (Eigen::Index k = 0; k < 9; ++k) {
      sum(i, k) += of_alpha(i, k).c[1];
      sum(i, k + 3) += of_alpha(i, k).c[0];  // since the change of one is the next one
      sum(i + 3, k) += of_alpha(i, k).c[0];
    }
  return sum;
}

/// The second derivatives of w·f at one point, f the integrand.
template <LeastOf F>
Square<F> curvature_of_integrand(const ChartSeries<least_order<F>, double>& psi, const Eigen::Vector3d& w,
                                 const Eigen::Matrix3d& inertia) {
  if constexpr (F == LeastOf::jerk) return curvature_of_jerk(psi, w);
  else if constexpr (F == LeastOf::acceleration)
    return LeastRateSum<double>(psi[0], psi[1], psi[2], w, Eigen::Vector3d::Zero()).curvature();
  else {
    const RateSlopes omega(psi[0], psi[1]);
    const Eigen::Vector3d slope = (inertia * omega.value).cross(w) + inertia * w.cross(omega.value);
    Square<F> sum = LeastRateSum<double>(psi[0], psi[1], psi[2], inertia * w, slope).curvature();
    const Eigen::Matrix3d turning = skew<double>(w) * inertia;
    sum.template topLeftCorner<6, 6>() -= omega.by.transpose() * (turning + turning.transpose()) * omega.by;
    return sum;
  }
}

/// What an end adds to the second derivatives by φ and by its rates: those of its ψ' and ψ'', weighted with `slopes`.
///
/// ω and α are functions of y, ψ' and ψ''. Those of the inverse have the second derivatives of -λ·(ω, α) in place of
/// those of μ·(ψ', ψ''), λ = (∂(ψ', ψ'')/∂(ω, α))ᵀ μ.
Eigen::Matrix<double, 9, 9> curvature_of_end(const ChartEndSlopes<3>& end, const Eigen::Vector3d& y, double side,
                                             const ChartEnd<3>& slopes, double h) {
  const ChartEnd<3> lambda = -end.by_rates.transpose() * slopes;
  const LeastRateSum<double> sum(y, end.values.head<3>(), end.values.tail<3>(), lambda.tail<3>() / (h * h),
                                 lambda.head<3>() / h);
  Eigen::Matrix<double, 9, 9> change = Eigen::Matrix<double, 9, 9>::Zero();
  change.topLeftCorner<3, 3>().diagonal().setConstant(side);
  change.bottomLeftCorner<6, 3>() = end.by_step;
  change.bottomRightCorner<6, 6>() = end.by_rates;
  return change.transpose() * sum.curvature() * change;
}

/// The second derivatives of μ·φ by both turns, φ = log(exp(-x) exp(φ) exp(y)).
Eigen::Matrix<double, 6, 6> curvature_of_step(const Eigen::Vector3d& step, const Eigen::Vector3d& mu) {
  const InverseJacobian inverse(step, inverse_coefficient(step.squaredNorm()));
  const Eigen::Matrix3d matrix = inverse.matrix();
  const Eigen::Matrix3d by_vector = inverse.by_vector(mu);
  const Eigen::Matrix3d by_reverse = by_vector + skew<double>(mu);  // of J_r⁻ᵀ: the odd part has the other sign
  Eigen::Matrix<double, 6, 6> curvature;
  curvature.topLeftCorner<3, 3>() = by_vector * matrix.transpose() + 0.5 * skew<double>(matrix * mu);
  curvature.bottomRightCorner<3, 3>() = by_reverse * matrix - 0.5 * skew<double>(matrix.transpose() * mu);
  curvature.bottomLeftCorner<3, 3>() = -by_reverse * matrix.transpose();
  curvature.topRightCorner<3, 3>() = curvature.bottomLeftCorner<3, 3>().transpose();
  return curvature;
}

}  // namespace

template <LeastOf F>
typename LeastElement<F>::Curved LeastElement<F>::curved(const Eigen::Vector3d& step, const Rates& leaving,
                                                         const Rates& arriving, double h,
                                                         const Eigen::Matrix3d& inertia) {
  constexpr int inner = 3 * static_cast<int>(least_parts);
  using Inner = Eigen::Matrix<double, inner, inner>;
  const LeastExpansion<F> e = least_expansion<F>(step, leaving, arriving, h, inertia);
  const double scale = least_scale<F>(h);
  Inner by_parts = Inner::Zero();  // the sum of f·∂²f
  for (std::size_t g = 0; g < least_rule().size(); ++g) {
    const LeastPoint& point = least_rule()[g];
    const Eigen::Vector3d w = (scale * point.root_weight) * e.residual.template segment<3>(3 * static_cast<int>(g));
    const auto curvature = curvature_of_integrand<F>(series_at<F, double>(point, e.values), w, inertia);
    Eigen::Matrix<double, Square<F>::RowsAtCompileTime, inner> functions;
    for (std::size_t k = 0; k <= least_order<F>; ++k)
      for (std::size_t part = 0; part < least_parts; ++part)
        functions.template block<3, 3>(3 * static_cast<Eigen::Index>(k), 3 * static_cast<Eigen::Index>(part)) =
            point.functions[k][part] * Eigen::Matrix3d::Identity();
    by_parts.noalias() += functions.transpose() * (curvature * functions);
  }
  const Eigen::Matrix<double, inner, 1> slopes = e.by_parts.transpose() * e.residual;
  Inner change = Inner::Zero();  // of the parts by φ and the rates
  change.template topLeftCorner<3, 3>().setIdentity();
  change.template block<6, 3>(3, 0) = e.start.by_step;
  change.template block<6, 6>(3, 3) = e.start.by_rates;
  change.template block<6, 3>(9, 0) = e.end.by_step;
  change.template block<6, 6>(9, 9) = e.end.by_rates;
  Inner hessian = change.transpose() * (by_parts * change);
  const Eigen::Vector3d half = 0.5 * step;
  hessian.template topLeftCorner<9, 9>() += curvature_of_end(e.start, -half, -0.5, slopes.template segment<6>(3), h);
  const auto end = curvature_of_end(e.end, half, 0.5, slopes.template tail<6>(), h);
  hessian.template topLeftCorner<3, 3>() += end.template topLeftCorner<3, 3>();
  hessian.template topRightCorner<3, 6>() += end.template topRightCorner<3, 6>();
  hessian.template bottomLeftCorner<6, 3>() += end.template bottomLeftCorner<6, 3>();
  hessian.template bottomRightCorner<6, 6>() += end.template bottomRightCorner<6, 6>();

  const Eigen::Matrix3d step_by_turn = right_jacobian_inverse<double>(step);
  Eigen::Matrix<double, inner, 2 * unknowns> by_unknowns = Eigen::Matrix<double, inner, 2 * unknowns>::Zero();
  by_unknowns.template topLeftCorner<3, 3>() = -step_by_turn.transpose();
  by_unknowns.template block<3, 3>(0, unknowns) = step_by_turn;
  by_unknowns.template block<6, 6>(3, 3).setIdentity();
  by_unknowns.template block<6, 6>(9, unknowns + 3).setIdentity();
  Curved curved{.gradient = e.jacobian.transpose() * e.residual,
                .hessian = e.jacobian.transpose() * e.jacobian,
                .weights = {damping_weights(e.jacobian.template leftCols<unknowns>()),
                            damping_weights(e.jacobian.template rightCols<unknowns>())}};
  curved.hessian.noalias() += by_unknowns.transpose() * (hessian * by_unknowns);
  const auto turns = curvature_of_step(step, e.by_step.transpose() * e.residual);
  curved.hessian.template topLeftCorner<3, 3>() += turns.template topLeftCorner<3, 3>();
  curved.hessian.template block<3, 3>(0, unknowns) += turns.template topRightCorner<3, 3>();
  curved.hessian.template block<3, 3>(unknowns, 0) += turns.template bottomLeftCorner<3, 3>();
  curved.hessian.template block<3, 3>(unknowns, unknowns) += turns.template bottomRightCorner<3, 3>();
  return curved;
}

template LeastElement<LeastOf::acceleration>::Curved LeastElement<LeastOf::acceleration>::curved(
    const Eigen::Vector3d&, const Rates&, const Rates&, double, const Eigen::Matrix3d&);
template LeastElement<LeastOf::torque>::Curved LeastElement<LeastOf::torque>::curved(const Eigen::Vector3d&,
                                                                                     const Rates&, const Rates&, double,
                                                                                     const Eigen::Matrix3d&);
template LeastElement<LeastOf::jerk>::Curved LeastElement<LeastOf::jerk>::curved(const Eigen::Vector3d&, const Rates&,
                                                                                 const Rates&, double,
                                                                                 const Eigen::Matrix3d&);

}}}  // namespace orispline::families
