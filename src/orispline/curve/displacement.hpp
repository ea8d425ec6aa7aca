// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

#include <orispline/math/so3.hpp>

namespace orispline {

// The step from one point to another, for orientations and for positions: a construction written over these gives a
// curve and its path.

/// What a curve goes through: an orientation or a position.
template <class P>
concept CurvePoint = std::same_as<P, Eigen::Quaterniond> || std::same_as<P, Eigen::Vector3d>;

/// The same kind of point over another number type.
template <CurvePoint P, Number T>
using PointOver = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Quaternion<T>, Vector3<T>>;

/// Rotation vector [rad] in the body frame of `from`.
template <Number T>
[[nodiscard]] Vector3<T> displacement(const Quaternion<T>& from, const Quaternion<T>& to) noexcept {
  return increment<T>(from, to);
}
template <Number T>
[[nodiscard]] Vector3<T> displacement(const Vector3<T>& from, const Vector3<T>& to) noexcept {
  return to - from;
}

template <Number T>
[[nodiscard]] Quaternion<T> displaced(const Quaternion<T>& from, const std::type_identity_t<Vector3<T>>& by) noexcept {
  return from * exp<T>(by);
}
template <Number T>
[[nodiscard]] Vector3<T> displaced(const Vector3<T>& from, const std::type_identity_t<Vector3<T>>& by) noexcept {
  return from + by;
}

/// The point at that share of the way between two.
template <class P>
[[nodiscard]] P on_the_way(const P& from, const P& to, double share) noexcept {
  using T = typename P::Scalar;
  return displaced(from, Vector3<T>(displacement(from, to) * T(share)));
}

}  // namespace orispline
