// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/so3.hpp>

// The papers' algebra: quaternions as 4-vectors with a product, logarithms as pure quaternions of half angle.

namespace orispline::testing_support {

/// A quaternion that need not be a unit: sums and products of logarithms.
class AnyQuaternion {
 public:
  AnyQuaternion(const Eigen::Quaterniond& q) : q_(q) {}  // NOLINT: a unit quaternion is one
  [[nodiscard]] const Eigen::Vector4d& coeffs() const { return q_.coeffs(); }

  friend AnyQuaternion operator*(const AnyQuaternion& a, const AnyQuaternion& b) {
    return Eigen::Quaterniond(a.q_ * b.q_);
  }
  friend AnyQuaternion operator+(const AnyQuaternion& a, const AnyQuaternion& b) { return sum(a, 1.0, b); }
  friend AnyQuaternion operator-(const AnyQuaternion& a, const AnyQuaternion& b) { return sum(a, -1.0, b); }
  friend AnyQuaternion operator*(double s, const AnyQuaternion& a) {
    return Eigen::Quaterniond(Eigen::Vector4d(s * a.coeffs()));
  }

 private:
  static AnyQuaternion sum(const AnyQuaternion& a, double s, const AnyQuaternion& b) {
    return Eigen::Quaterniond(Eigen::Vector4d(a.coeffs() + s * b.coeffs()));
  }
  Eigen::Quaterniond q_;
};

/// log(from⁻¹ to) in the papers' measure: half the rotation vector as a pure quaternion.
[[nodiscard]] inline AnyQuaternion half_log(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const Eigen::Vector3d half = 0.5 * increment<double>(from, to);
  return Eigen::Quaterniond(0.0, half.x(), half.y(), half.z());
}

}  // namespace orispline::testing_support
