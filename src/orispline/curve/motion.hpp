// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Orientation with its rates at one time, over any Number. The rates are in the **body** frame.
template <Number T>
struct MotionOver {
  Quaternion<T> orientation = Quaternion<T>::Identity();  ///< body to world
  Vector3<T> angular_velocity = Vector3<T>::Zero();       ///< ω = 2 vec(q̄ q̇) [rad/s]
  Vector3<T> angular_acceleration = Vector3<T>::Zero();   ///< α = dω/dt [rad/s²]
  Vector3<T> angular_jerk = Vector3<T>::Zero();           ///< dα/dt [rad/s³]
};
using Motion = MotionOver<double>;

/// Position with its rates at one time, in the **world** frame.
struct LinearMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< [m/s²]
  Eigen::Vector3d jerk = Eigen::Vector3d::Zero();          ///< [m/s³]
};

/// How a point of one kind moves.
template <CurvePoint P>
using MotionOf = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Motion, LinearMotion>;

/// The motion at a time that is none: all NaN.
template <CurvePoint P>
[[nodiscard]] MotionOf<P> no_motion() noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d none = Eigen::Vector3d::Constant(nan);
  if constexpr (std::same_as<P, Eigen::Quaterniond>) return {{nan, nan, nan, nan}, none, none, none};
  else return {none, none, none, none};
}

/// ω in the world frame [rad/s]: R ω.
[[nodiscard]] inline Eigen::Vector3d angular_velocity_world(const Motion& m) noexcept {
  return to_world<double>(m.orientation, m.angular_velocity);
}

/// dω_world/dt [rad/s²]: R α, for the transport term ω × ω is zero.
[[nodiscard]] inline Eigen::Vector3d angular_acceleration_world(const Motion& m) noexcept {
  return to_world<double>(m.orientation, m.angular_acceleration);
}

/// What turning axes add to the jerk [rad/s³], in the body frame: ω × α.
[[nodiscard]] inline Eigen::Vector3d transport_of_jerk(const Eigen::Vector3d& angular_velocity,
                                                       const Eigen::Vector3d& angular_acceleration) noexcept {
  return angular_velocity.cross(angular_acceleration);
}

/// d²ω_world/dt² [rad/s³]: R (jerk + ω × α).
[[nodiscard]] inline Eigen::Vector3d angular_jerk_world(const Motion& m) noexcept {
  return to_world<double>(m.orientation,
                          m.angular_jerk + transport_of_jerk(m.angular_velocity, m.angular_acceleration));
}

/// Orientation and body rates from a quaternion given with its first three time derivatives.
///
/// ω = 2 vec(q̄ q̇) as a power series; its next two coefficients are α and half the jerk.
template <Number T>
[[nodiscard]] MotionOver<T> motion_from_jet(const Quaternion<Jet<T, 3>>& q) noexcept {
  const auto order = [&q](std::size_t k) { return Quaternion<T>(q.w().c[k], q.x().c[k], q.y().c[k], q.z().c[k]); };
  const auto term = [&order](std::size_t conjugated, std::size_t plain) -> Vector3<T> {
    return T(2.0 * static_cast<double>(plain)) * (order(conjugated).conjugate() * order(plain)).vec();
  };
  return {.orientation = order(0),
          .angular_velocity = term(0, 1),
          .angular_acceleration = term(0, 2) + term(1, 1),
          .angular_jerk = T(2.0) * (term(0, 3) + term(1, 2) + term(2, 1))};
}

/// Position and rates from a position given with its first three time derivatives.
[[nodiscard]] inline LinearMotion motion_from_jet(const Vector3<Jet<double, 3>>& p) noexcept {
  const auto order = [&p](std::size_t k) {
    return Eigen::Vector3d(p.x().derivative(k), p.y().derivative(k), p.z().derivative(k));
  };
  return {.position = order(0), .velocity = order(1), .acceleration = order(2), .jerk = order(3)};
}

/// What turns a free rigid body so: J α + ω × J ω [N m], body frame (Euler's equation).
///
/// `inertia`: J [kg m²] about the centre of mass, body frame, symmetric and positive definite.
template <Number T>
[[nodiscard]] Vector3<T> torque(const MotionOver<T>& m, const Eigen::Matrix3d& inertia) noexcept {
  const Matrix3<T>& J = inertia.cast<T>();
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
