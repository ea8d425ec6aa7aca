// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/LU>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Spherical averages of control orientations: q(t) solves Σ N_k(t) log(q⁻¹ p_k) = 0 with the cubic B-spline functions
/// N.
///
/// Newton's method finds the average; once converged, each further step with the same Jacobian over jets makes one more
/// order of the derivatives exact. Source: Buss & Fillmore 2001, section 3 (the averages), 4.1 (the splines).
class AverageCurve {
 public:
  static constexpr std::size_t active = 4;  ///< control orientations that a segment averages
  template <Number T>
  using Weights = std::array<T, active>;

  /// Segment i averages points i … i+3.
  AverageCurve(Knots knots, BSplineBasis<3> basis, std::vector<Eigen::Quaterniond> points)
      : knots_(std::move(knots)), basis_(std::move(basis)), points_(std::move(points)) {
    ORISPLINE_EXPECT(points_.size() == knots_.segments() + 3);
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] const std::vector<Eigen::Quaterniond>& points() const noexcept { return points_; }

  template <Number T>
  [[nodiscard]] Weights<T> weights(const T& t, std::size_t segment) const noexcept {
    const auto tails = basis_(knots_.span(segment), t);
    return {T(1.0) - tails[0], tails[0] - tails[1], tails[1] - tails[2], tails[2]};
  }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    const Weights<T> w = weights(t, segment);
    Weights<double> values{};
    for (std::size_t k = 0; k < active; ++k) values[k] = static_cast<double>(value_of(w[k]));
    Eigen::Quaterniond average = averaged(values, segment);
    if constexpr (std::is_same_v<T, double>) {
      return average;
    } else {
      const Eigen::Matrix3d newton = jacobian(average, values, segment).inverse();
      Quaternion<T> q = constant<T>(average);
      for (std::size_t order = 1; order < T::size; ++order)
        q = q * exp<T>(Vector3<T>(newton.template cast<T>() * missing<T>(q, w, segment)));
      return q;
    }
  }

  /// What q misses the average by [rad]: Σ w_k log(q⁻¹ p_k).
  template <Number T>
  [[nodiscard]] Vector3<T> missing(const Quaternion<T>& q, const Weights<T>& w, std::size_t segment) const noexcept {
    Vector3<T> sum = Vector3<T>::Zero();
    for (std::size_t k = 0; k < active; ++k) sum += increment<T>(q, constant<T>(points_[segment + k])) * w[k];
    return sum;
  }

 private:
  /// Less the derivative of what is missing by a turn of q.
  [[nodiscard]] Eigen::Matrix3d jacobian(const Eigen::Quaterniond& q, const Weights<double>& w,
                                         std::size_t segment) const noexcept {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < active; ++k)
      sum += w[k] * left_jacobian_inverse<double>(increment<double>(q, points_[segment + k]));
    return sum;
  }

  /// Where the search begins: the normalised mean of the quaternions, or the heaviest one where they cancel.
  [[nodiscard]] Eigen::Quaterniond mean(const Weights<double>& w, std::size_t segment) const noexcept {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    std::size_t heaviest = 0;
    for (std::size_t k = 0; k < active; ++k) {
      sum += w[k] * points_[segment + k].coeffs();
      if (w[k] > w[heaviest]) heaviest = k;
    }
    return sum.norm() <= 1e-3 ? points_[segment + heaviest] : Eigen::Quaterniond(sum.normalized());  // NaN stays NaN
  }

  /// Newton's steps, or where they lead nowhere those of steepest descent, as long as less and less is missing.
  [[nodiscard]] Eigen::Quaterniond averaged(const Weights<double>& w, std::size_t segment) const noexcept {
    constexpr int enough = 100;  // steps; a handful reach rounding
    Eigen::Quaterniond q = mean(w, segment);
    Eigen::Vector3d left = missing<double>(q, w, segment);
    for (int i = 0; i < enough; ++i) {
      const Eigen::Vector3d newton = jacobian(q, w, segment).inverse() * left, descent = left;
      bool nearer = false;
      for (const Eigen::Vector3d& step : {newton, descent}) {
        const Eigen::Quaterniond there = (q * exp<double>(step)).normalized();
        const Eigen::Vector3d then = missing<double>(there, w, segment);
        nearer = then.norm() < left.norm();
        if (!nearer) continue;
        q = there;
        left = then;
        break;
      }
      if (!nearer) return q;
    }
    return q;
  }

  Knots knots_;
  BSplineBasis<3> basis_;
  std::vector<Eigen::Quaterniond> points_;
};

}}  // namespace orispline
