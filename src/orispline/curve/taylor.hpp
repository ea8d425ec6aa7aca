// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/motion.hpp>
#include <orispline/math/jet.hpp>

// The point of a curve over jets, by the Taylor polynomial of its motion: of curves that state that alone.

namespace orispline { inline namespace ORISPLINE_ABI {

/// `h`: what the time has beyond that of the motion [s], with its derivatives.
[[nodiscard]] inline Quaternion<Jet<double, 3>> taylor(const Motion& m, const Jet<double, 3>& h) noexcept {
  const auto pure = [](const Eigen::Vector3d& v) { return Eigen::Quaterniond(0.0, v.x(), v.y(), v.z()); };
  const Eigen::Quaterniond& q = m.orientation;
  const auto w = pure(m.angular_velocity), a = pure(m.angular_acceleration), j = pure(m.angular_jerk);
  const Eigen::Vector4d first = 0.5 * (q * w).coeffs();
  const Eigen::Quaterniond q1(first);
  const Eigen::Vector4d second = 0.5 * ((q1 * w).coeffs() + (q * a).coeffs());
  const Eigen::Vector4d third =
      0.5 * ((Eigen::Quaterniond(second) * w).coeffs() + 2.0 * (q1 * a).coeffs() + (q * j).coeffs());
  Quaternion<Jet<double, 3>> result;
  for (Eigen::Index i = 0; i < 4; ++i)
    result.coeffs()[i] = q.coeffs()[i] + h * (first[i] + h * (second[i] / 2.0 + h * (third[i] / 6.0)));
  return result;
}
[[nodiscard]] inline Vector3<Jet<double, 3>> taylor(const LinearMotion& m, const Jet<double, 3>& h) noexcept {
  Vector3<Jet<double, 3>> result;
  for (Eigen::Index i = 0; i < 3; ++i)
    result[i] = m.position[i] + h * (m.velocity[i] + h * (m.acceleration[i] / 2.0 + h * (m.jerk[i] / 6.0)));
  return result;
}

}}  // namespace orispline
