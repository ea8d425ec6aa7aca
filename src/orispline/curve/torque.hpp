// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What turns a free rigid body so: J α + ω × J ω [N m], body frame (Euler's equation).
///
/// `inertia`: J [kg m²] about the centre of mass, body frame, symmetric and positive definite.
template <Number T>
[[nodiscard]] Vector3<T> torque(const MotionOver<T>& m, const Eigen::Matrix3d& inertia) noexcept {
  const Matrix3<T> J = inertia.cast<T>();
  const Vector3<T> momentum = J * m.angular_velocity;
  return J * m.angular_acceleration + m.angular_velocity.cross(momentum);
}

/// Its derivative as seen from the body [N m/s]: J jerk + α × J ω + ω × J α.
[[nodiscard]] inline Eigen::Vector3d torque_rate(const Motion& m, const Eigen::Matrix3d& inertia) noexcept {
  return inertia * m.angular_jerk + m.angular_acceleration.cross(inertia * m.angular_velocity) +
         m.angular_velocity.cross(inertia * m.angular_acceleration);
}

/// The matrix, if it is symmetric and positive definite. Error: bad_argument.
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Matrix3d> checked_inertia(const Eigen::Matrix3d& inertia);

/// No principal moment is greater than the sum of the two others: what holds for every distribution of mass. The torque
/// of another tensor is a weighting of accelerations as good as any, but nobody's torque.
[[nodiscard]] ORISPLINE_EXPORT bool is_physical_inertia(const Eigen::Matrix3d& inertia);

/// `no_rigid_body`, where the inertia is not a physical one.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Warning> warnings_of(const Eigen::Matrix3d& inertia);

}}  // namespace orispline
