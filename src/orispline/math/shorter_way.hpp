// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/geodesic.hpp>

// The same words for orientations and for positions where the signs of quaternions mean nothing.

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far two points are from each other [rad, or the unit of positions].
[[nodiscard]] inline double distance_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) noexcept {
  return angular_distance(a, b);
}
[[nodiscard]] inline double distance_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return (a - b).norm();
}

/// `to`, with the sign of the nearer of the two quaternions that are its rotation.
[[nodiscard]] inline Eigen::Quaterniond with_sign_near(const Eigen::Quaterniond& to, const Eigen::Quaterniond& from) {
  return from.dot(to) < 0.0 ? Eigen::Quaterniond(-to.coeffs()) : to;
}
[[nodiscard]] inline Eigen::Vector3d with_sign_near(const Eigen::Vector3d& to, const Eigen::Vector3d&) { return to; }

/// The displacement of the shorter way.
template <CurvePoint P>
[[nodiscard]] Displacement<P> shortest_displacement(const P& from, const P& to) {
  return displacement<double>(from, with_sign_near(to, from));
}

}}  // namespace orispline
