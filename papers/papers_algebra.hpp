// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <orispline/math/so3.hpp>

namespace orispline::cli {

/// The papers' algebra: a quaternion of any length. Logarithms are pure quaternions of half angle.
class AnyQuaternion {
 public:
  AnyQuaternion(const Eigen::Quaterniond& q) : q_(q) {}  // NOLINT: a unit quaternion is one
  AnyQuaternion(double w, const Eigen::Vector3d& v) : q_(w, v.x(), v.y(), v.z()) {}

  [[nodiscard]] double scalar() const { return q_.w(); }
  [[nodiscard]] Eigen::Vector3d vector() const { return q_.vec(); }
  [[nodiscard]] AnyQuaternion conjugate() const { return q_.conjugate(); }
  /// Eberly's N, (4): the squared length.
  [[nodiscard]] double norm() const { return q_.squaredNorm(); }
  [[nodiscard]] AnyQuaternion inverse() const { return (1.0 / norm()) * conjugate(); }
  [[nodiscard]] const Eigen::Quaterniond& coefficients() const { return q_; }

  friend AnyQuaternion operator*(const AnyQuaternion& a, const AnyQuaternion& b) {
    return Eigen::Quaterniond(a.q_ * b.q_);
  }
  friend AnyQuaternion operator*(double s, const AnyQuaternion& a) {
    return Eigen::Quaterniond(Eigen::Vector4d(s * a.q_.coeffs()));
  }
  friend AnyQuaternion operator+(const AnyQuaternion& a, const AnyQuaternion& b) {
    return Eigen::Quaterniond(Eigen::Vector4d(a.q_.coeffs() + b.q_.coeffs()));
  }
  friend AnyQuaternion operator-(const AnyQuaternion& a, const AnyQuaternion& b) { return a + -1.0 * b; }

 private:
  Eigen::Quaterniond q_;
};

/// log(q) of a unit quaternion as the papers have it.
[[nodiscard]] inline AnyQuaternion half_log(const AnyQuaternion& q) {
  return {0.0, 0.5 * log<double>(q.coefficients())};
}

/// exp of a pure quaternion as the papers have it.
[[nodiscard]] inline AnyQuaternion half_exp(const Eigen::Vector3d& v) { return exp<double>(Eigen::Vector3d(2.0 * v)); }

/// The length of a - b.
[[nodiscard]] inline double gap(const AnyQuaternion& a, const AnyQuaternion& b) { return std::sqrt((a - b).norm()); }

/// The k-th derivative of a quaternion given as a jet.
template <int N>
[[nodiscard]] AnyQuaternion derivative(const Quaternion<Jet<double, N>>& q, std::size_t k) {
  return Eigen::Quaterniond(q.w().derivative(k), q.x().derivative(k), q.y().derivative(k), q.z().derivative(k));
}

}  // namespace orispline::cli
