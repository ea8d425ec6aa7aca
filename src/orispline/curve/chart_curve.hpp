// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/two_point_blending.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Body rate of exp(p(t)) as a power series of one order less: ω = J_r(p) ṗ.
template <Number T, int N>
[[nodiscard]] Vector3<Jet<T, N - 1>> chart_rate(const Vector3<Jet<T, N>>& p) noexcept {
  using J = Jet<T, N - 1>;
  Vector3<J> value, derivative;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < J::size; ++k) {
      value[axis].c[k] = p[axis].c[k];
      derivative[axis].c[k] = p[axis].c[k + 1] * Plain<T>(static_cast<double>(k + 1));
    }
  const J x = value.squaredNorm();
  const Vector3<J> turn = value.cross(derivative);
  return derivative - turn * series::versine_ratio(x) + value.cross(turn) * series::sine_defect_ratio(x);
}

/// Body acceleration of exp(p(t)) at one p: α = J_r(p) p̈ + N(p, ṗ), N quadratic in ṗ.
///
/// What is there of p alone is found once. Source: docs/families/auto.md, Formula (5).
class ChartAcceleration {
 public:
  explicit ChartAcceleration(const Eigen::Vector3d& p);

  template <Number T>
  [[nodiscard]] Vector3<T> operator()(const Vector3<T>& velocity, const Vector3<T>& acceleration) const noexcept {
    const Vector3<T> turned = p_.cross(velocity);
    return jacobian_ * acceleration + (changing_ * velocity) * T(p_.dot(velocity)) + velocity.cross(turned) * defect_;
  }

 private:
  Eigen::Vector3d p_;
  Eigen::Matrix3d jacobian_, changing_;
  double defect_;
};

/// Time derivatives of orders 1…3 of a rotation vector.
using ChartDerivatives = std::array<Eigen::Vector3d, 3>;

/// The derivatives of orders 1…K that p(t) must have at p for exp(p(t)) to have the given body rates: ω, α, jerk. Those
/// of higher order are zero, or unused.
///
/// ‖p‖ < 2π. The exact change of chart: two segments that ask for the same rates join smoothly whatever their charts.
template <std::size_t K>
[[nodiscard]] ChartDerivatives chart_derivatives(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& rates);

/// The body rates ω, α, jerk of exp(p(t)), p(t) with these derivatives at p: the inverse of the above.
[[nodiscard]] std::array<Eigen::Vector3d, 3> body_rates(const Eigen::Vector3d& p, const ChartDerivatives& derivatives);

/// One interval of a chart curve: q = base · exp(ψ(u)), ψ a polynomial of rotation vectors in Bernstein form [rad].
template <std::size_t Degree>
struct ChartPiece {
  Eigen::Quaterniond base;
  std::array<Eigen::Vector3d, Degree + 1> coefficients;
};

/// ψ(u) of a piece.
template <std::size_t Degree, Number T>
[[nodiscard]] Vector3<T> rotation_vector(const ChartPiece<Degree>& piece, const T& u) noexcept {
  const auto basis = bernstein_basis<Degree>(u);
  Vector3<T> sum = Vector3<T>::Constant(T(0.0));
  for (std::size_t i = 0; i <= Degree; ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis) sum[axis] += basis[i] * Plain<T>(piece.coefficients[i][axis]);
  return sum;
}

/// The motion base · exp(p(t)).
[[nodiscard]] inline Motion chart_motion(const Eigen::Quaterniond& base, const Vector3<Jet<double, 3>>& p) noexcept {
  const auto omega = chart_rate<double, 3>(p);
  const auto order = [&omega](std::size_t k) {
    return Eigen::Vector3d(omega.x().derivative(k), omega.y().derivative(k), omega.z().derivative(k));
  };
  return {.orientation = base * exp<double>({p.x().c[0], p.y().c[0], p.z().c[0]}),
          .angular_velocity = order(0),
          .angular_acceleration = order(1),
          .angular_jerk = order(2)};
}

/// A curve that is one exponential of a vector polynomial on every interval.
template <std::size_t Degree>
class ChartCurve {
 public:
  ChartCurve(Knots knots, std::vector<ChartPiece<Degree>> pieces)
      : knots_(std::move(knots)), pieces_(std::move(pieces)) {
    ORISPLINE_EXPECT(pieces_.size() == knots_.segments());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    return constant<T>(pieces_[segment].base) * exp<T>(rotation_vector(t, segment));
  }

  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    return chart_motion(pieces_[segment].base, rotation_vector(Jet<double, 3>::variable(t), segment));
  }

  /// The segment as polynomials.
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept {
    static_assert(Degree <= form_degree);
    ChartForm form{.degree = Degree, .base = pieces_[segment].base, .rotation_vector = {}};
    for (std::size_t i = 0; i <= Degree; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        form.rotation_vector[axis].coefficients[i] = pieces_[segment].coefficients[i][static_cast<Eigen::Index>(axis)];
    return form;
  }

 private:
  template <Number T>
  [[nodiscard]] Vector3<T> rotation_vector(const T& t, std::size_t segment) const noexcept {
    return orispline::rotation_vector(pieces_[segment], knots_.span(segment).normalised(t));
  }

  Knots knots_;
  std::vector<ChartPiece<Degree>> pieces_;
};

/// The piece of degree 2K+1 from `start` to `end` in the chart at `base`, with these derivatives of orders 1…K at both.
/// h is its duration [s].
template <std::size_t K>
[[nodiscard]] ChartPiece<2 * K + 1> chart_piece(const Eigen::Quaterniond& base, const Eigen::Vector3d& start,
                                                const Eigen::Vector3d& end, const ChartDerivatives& leaving,
                                                const ChartDerivatives& arriving, double h) {
  const auto local = [h](const ChartDerivatives& d) {  // in the local parameter: order m times h^m
    std::array<Eigen::Vector3d, K> scaled;
    double power = 1.0;
    for (std::size_t m = 0; m < K; ++m) scaled[m] = (power *= h) * d[m];
    return scaled;
  };
  const auto left = bernstein_from_taylor(start, local(leaving));
  const auto right = bernstein_from_taylor(end, inwards(local(arriving)));
  ChartPiece<2 * K + 1> piece{.base = base, .coefficients = {}};
  for (std::size_t i = 0; i <= K; ++i) {
    piece.coefficients[i] = left[i];
    piece.coefficients[2 * K + 1 - i] = right[i];
  }
  return piece;
}

/// The piece of degree 2K+1 after `start` by `step`, in the chart at `start`, with the given body rates of orders 1…K
/// at both ends.
template <std::size_t K>
[[nodiscard]] ChartPiece<2 * K + 1> hermite_piece(const Eigen::Quaterniond& start, const Eigen::Vector3d& step,
                                                  const std::array<Eigen::Vector3d, 3>& leaving,
                                                  const std::array<Eigen::Vector3d, 3>& arriving, double h) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return chart_piece<K>(start, zero, step, chart_derivatives<K>(zero, leaving), chart_derivatives<K>(step, arriving),
                        h);
}

/// The quintic after `start` by `step`, in the chart at the middle between its ends, with the given ω and α at both.
[[nodiscard]] ChartPiece<5> hermite_piece_about_middle(const Eigen::Quaterniond& start, const Eigen::Vector3d& step,
                                                       const std::array<Eigen::Vector3d, 3>& leaving,
                                                       const std::array<Eigen::Vector3d, 3>& arriving, double h);

}}  // namespace orispline
