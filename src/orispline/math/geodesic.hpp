// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <vector>

#include <orispline/math/so3.hpp>

// The same words for orientations and for positions: a construction from geodesics is written once and gives the curve
// and its Euclidean analogue.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Spherical linear interpolation a (a⁻¹b)^s: the geodesic from a (s = 0) to b (s = 1) at constant rate.
///
/// Takes the signs that it is given: if a·b < 0 it goes the long way. s may lie outside [0, 1]. With `Jet` numbers it
/// yields the derivatives, also when a, b and s all move.
/// Source: Eberly, (16).
template <Number T>
[[nodiscard]] Quaternion<T> slerp(const Quaternion<T>& a, const Quaternion<T>& b, const T& s) noexcept {
  return a * exp<T>(increment(a, b) * s);
}

/// Spherical quadrangle interpolation from p to q with inner quaternions a and b, s in [0, 1].
///
/// Source: Eberly, (18): slerp(slerp(p, q; s), slerp(a, b; s); 2s(1-s)).
template <Number T>
[[nodiscard]] Quaternion<T> squad(const Quaternion<T>& p, const Quaternion<T>& a, const Quaternion<T>& b,
                                  const Quaternion<T>& q, const T& s) noexcept {
  return slerp<T>(slerp<T>(p, q, s), slerp<T>(a, b, s), T(2.0) * s * (T(1.0) - s));
}

/// What a curve goes through: an orientation or a position.
template <class P>
concept CurvePoint = std::same_as<P, Eigen::Quaterniond> || std::same_as<P, Eigen::Vector3d>;

/// A point of that kind over another number type.
template <CurvePoint P, Number T>
using PointOver = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Quaternion<T>, Vector3<T>>;

/// What leads from one point to another of its kind: a rotation vector [rad] in the body frame of the first one, or a
/// difference of positions [m].
template <CurvePoint P, Number T = double>
using Displacement = Vector3<T>;

/// The displacement along the geodesic from one point to the other.
template <Number T>
[[nodiscard]] Vector3<T> displacement(const Quaternion<T>& from, const Quaternion<T>& to) noexcept {
  return increment<T>(from, to);
}
template <Number T>
[[nodiscard]] Vector3<T> displacement(const Vector3<T>& from, const Vector3<T>& to) noexcept {
  return to - from;
}

/// The point at that displacement: displaced(a, displacement(a, b)) is b.
template <Number T>
[[nodiscard]] Quaternion<T> displaced(const Quaternion<T>& from, const std::type_identity_t<Vector3<T>>& by) noexcept {
  return from * exp<T>(by);
}
template <Number T>
[[nodiscard]] Vector3<T> displaced(const Vector3<T>& from, const std::type_identity_t<Vector3<T>>& by) noexcept {
  return from + by;
}

/// The point at which displacements one after the other end: the product of their exponentials, or their sum.
template <Number T, std::size_t N>
[[nodiscard]] Quaternion<T> displaced_in_turn(Quaternion<T> from, const std::array<Vector3<T>, N>& by) noexcept {
  for (const Quaternion<T>& factor : exp_of_each(by)) from = from * factor;
  return from;
}
template <Number T, std::size_t N>
[[nodiscard]] Vector3<T> displaced_in_turn(Vector3<T> from, const std::array<Vector3<T>, N>& by) noexcept {
  for (const Vector3<T>& step : by) from += step;
  return from;
}

/// The point at fraction s of the geodesic from a to b: slerp, or the straight line. s may lie outside [0, 1].
template <Number T>
[[nodiscard]] Quaternion<T> on_geodesic(const Quaternion<T>& a, const Quaternion<T>& b,
                                        const std::type_identity_t<T>& s) noexcept {
  return slerp<T>(a, b, s);
}
template <Number T>
[[nodiscard]] Vector3<T> on_geodesic(const Vector3<T>& a, const Vector3<T>& b,
                                     const std::type_identity_t<T>& s) noexcept {
  return a + (b - a) * s;
}

/// The image of a point in another one, as far beyond it on the geodesic as the point lies before it.
[[nodiscard]] inline Eigen::Quaterniond mirrored(const Eigen::Quaterniond& at,
                                                 const Eigen::Quaterniond& point) noexcept {
  return at * point.conjugate() * at;
}
[[nodiscard]] inline Eigen::Vector3d mirrored(const Eigen::Vector3d& at, const Eigen::Vector3d& point) noexcept {
  return 2.0 * at - point;
}

/// From each point of a list to the next: n of them give n-1 displacements, rotation vectors [rad] or differences [m].
template <class Points>
[[nodiscard]] auto increments_between(const Points& points) {
  using P = typename Points::value_type;
  std::vector<Displacement<P>> increments;
  increments.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    increments.push_back(displacement<double>(points[i], points[i + 1]));
  return increments;
}

}}  // namespace orispline
