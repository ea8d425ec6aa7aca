// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Spherical averages of control orientations: q(t) solves Σ N_k(t) log(q⁻¹ p_k) = 0 with the cubic B-spline functions
/// N.
///
/// Newton's method finds the average, which is where the weighted sum of squared distances is least: a step counts only
/// where that sum does not rise, since the equation holds at its saddles and maxima too. Once converged, each further
/// step with the same Jacobian over jets makes one more order of the derivatives exact. Source: Buss & Fillmore 2001,
/// section 3 (the averages), 4.1 (the splines).
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
      const Eigen::Matrix3d newton = jacobian(ways<double>(average, segment), values).inverse();
      Quaternion<T> q = constant<T>(average);
      for (std::size_t order = 1; order < T::size; ++order)
        q = q * exp<T>(Vector3<T>(newton.template cast<T>() * missing<T>(q, w, segment)));
      return q;
    }
  }

  /// What q misses the average by [rad]: Σ w_k log(q⁻¹ p_k).
  template <Number T>
  [[nodiscard]] Vector3<T> missing(const Quaternion<T>& q, const Weights<T>& w, std::size_t segment) const noexcept {
    return weighted(ways<T>(q, segment), w);
  }

 private:
  template <Number T>
  using Ways = std::array<Vector3<T>, active>;  // log(q⁻¹ p_k) [rad]

  template <Number T>
  [[nodiscard]] Ways<T> ways(const Quaternion<T>& q, std::size_t segment) const noexcept {
    Ways<T> all;
    for (std::size_t k = 0; k < active; ++k) all[k] = increment<T>(q, constant<T>(points_[segment + k]));
    return all;
  }
  template <Number T>
  [[nodiscard]] static Vector3<T> weighted(const Ways<T>& ways, const Weights<T>& w) noexcept {
    Vector3<T> sum = Vector3<T>::Zero();
    for (std::size_t k = 0; k < active; ++k) sum += ways[k] * w[k];
    return sum;
  }

  /// Less the derivative of what is missing by a turn of q.
  [[nodiscard]] static Eigen::Matrix3d jacobian(const Ways<double>& ways, const Weights<double>& w) noexcept {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < active; ++k) sum += w[k] * left_jacobian_inverse<double>(ways[k]);
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

  /// An orientation, and how far it is from the average.
  struct Place {
    Eigen::Quaterniond orientation;
    Ways<double> ways;
    Eigen::Vector3d missing;
    double squares = 0.0;  ///< weighted sum of squared distances [rad²]

    Place(const AverageCurve& curve, const Eigen::Quaterniond& q, const Weights<double>& w, std::size_t segment)
        : orientation(q), ways(curve.ways<double>(q, segment)), missing(weighted(ways, w)) {
      for (std::size_t k = 0; k < active; ++k) squares += w[k] * ways[k].squaredNorm();
    }

    [[nodiscard]] bool misses_less(const Place& other) const { return missing.norm() < other.missing.norm(); }
    /// Of the squares, by more than their rounding.
    [[nodiscard]] bool is_lower(const Place& other) const { return squares < (1.0 - rounding) * other.squares; }
    [[nodiscard]] bool is_higher(const Place& other) const { return !(squares <= (1.0 + rounding) * other.squares); }
    static constexpr double rounding = 1e-12;
  };

  /// Whether the sum of squares is curved upwards in every direction; the skew part of a Jacobian bends nothing.
  [[nodiscard]] static bool is_convex(const Eigen::Matrix3d& jacobian) {
    return Eigen::LLT<Eigen::Matrix3d>(0.5 * (jacobian + jacobian.transpose())).info() == Eigen::Success;
  }

  /// Newton's steps where they lead to the least sum of squares, else those of steepest descent.
  [[nodiscard]] Eigen::Quaterniond averaged(const Weights<double>& w, std::size_t segment) const noexcept {
    constexpr int enough = 100;  // steps; a handful reach rounding
    Place here(*this, mean(w, segment), w, segment);
    for (int i = 0; i < enough; ++i) {
      const Eigen::Matrix3d slope = jacobian(here.ways, w);
      const bool convex = is_convex(slope);
      Place there = beside(here, slope.inverse() * here.missing, w, segment);
      if (!convex || there.is_higher(here) || !there.misses_less(here)) {
        there = convex ? beside(here, here.missing, w, segment) : far_below(here, w, segment);
        const bool goes_on = there.is_lower(here) || there.misses_less(here) || (!convex && here.missing.norm() > 0.0);
        if (there.is_higher(here) || !goes_on) break;
      }
      here = there;
    }
    return here.orientation;
  }

  [[nodiscard]] Place beside(const Place& place, const Eigen::Vector3d& step, const Weights<double>& w,
                             std::size_t segment) const noexcept {
    return Place(*this, (place.orientation * exp<double>(step)).normalized(), w, segment);
  }

  /// By steepest descent away from a saddle, the farther the lower. A step as long as what is missing lowers the
  /// squares by |missing|² at least, since no squared distance bends more than in flat space.
  [[nodiscard]] Place far_below(const Place& place, const Weights<double>& w, std::size_t segment) const noexcept {
    constexpr double longest = 1.0;  // [rad]
    Eigen::Vector3d step = place.missing;
    Place there = beside(place, step, w, segment);
    while (step.norm() > 0.0 && (step *= 2.0).norm() < longest) {
      const Place beyond = beside(place, step, w, segment);
      if (beyond.is_higher(there)) break;
      there = beyond;
    }
    return there;
  }

  Knots knots_;
  BSplineBasis<3> basis_;
  std::vector<Eigen::Quaterniond> points_;
};

}}  // namespace orispline
