// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/so3.hpp>

namespace orispline {

/// Orientation with its rates at one time. The rates are in the **body** frame.
struct Motion {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< ω = 2 vec(q̄ q̇) [rad/s]
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();   ///< α = dω/dt [rad/s²]
  Eigen::Vector3d angular_jerk = Eigen::Vector3d::Zero();           ///< dα/dt [rad/s³]
};

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
[[nodiscard]] inline Motion motion_from_jet(const Quaternion<Jet<double, 3>>& q) noexcept {
  const auto order = [&q](std::size_t k) { return Eigen::Quaterniond(q.w().c[k], q.x().c[k], q.y().c[k], q.z().c[k]); };
  const auto term = [&order](std::size_t conjugated, std::size_t plain) -> Eigen::Vector3d {
    return 2.0 * static_cast<double>(plain) * (order(conjugated).conjugate() * order(plain)).vec();
  };
  return {.orientation = order(0),
          .angular_velocity = term(0, 1),
          .angular_acceleration = term(0, 2) + term(1, 1),
          .angular_jerk = 2.0 * (term(0, 3) + term(1, 2) + term(2, 1))};
}

}  // namespace orispline
