// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <numbers>

#include <orispline/math/eigen.hpp>
#include <orispline/math/series.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Euclidean norm, where squares would overflow or underflow too.
template <std::floating_point T>
[[nodiscard]] T norm_of(const Vector3<T>& v) noexcept {
  using Limits = std::numeric_limits<T>;
  const T square = v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
  const bool in_range = Limits::min() / Limits::epsilon() <= square && square <= Limits::max();
  return in_range ? sqrt_of(square) : v.stableNorm();  // which takes several times as long
}

/// Unit quaternion of half a rotation vector, of its length and of that angle's sine and cosine.
template <std::floating_point T>
[[nodiscard]] Quaternion<T> unit_quaternion(const Vector3<T>& half, T angle, T sine, T cosine) noexcept {
  const T s = angle > T(0) ? sine / angle : T(1);
  return Quaternion<T>(cosine, s * half.x(), s * half.y(), s * half.z());
}

/// Unit quaternion of a rotation vector φ [rad, full angle]: cos(‖φ‖/2) + sin(‖φ‖/2) φ/‖φ‖.
///
/// Source: Eberly, (10), there with half-angle vectors.
template <Number T>
[[nodiscard]] Quaternion<T> exp(const Vector3<T>& phi) noexcept {
  const Vector3<T> half = phi * T(0.5);
  if constexpr (std::floating_point<T>) {
    const T angle = norm_of<T>(half);
    T sine, cosine;
    sin_cos(angle, sine, cosine);
    return unit_quaternion(half, angle, sine, cosine);
  } else {
    const T x = half.squaredNorm(), s = series::sinc_sqrt(x);
    return Quaternion<T>(series::cos_sqrt(x), s * half.x(), s * half.y(), s * half.z());
  }
}

/// exp() of several rotation vectors at once: none waits for another.
template <std::size_t N, Number T>
[[nodiscard]] std::array<Quaternion<T>, N> exp_of_each(const std::array<Vector3<T>, N>& phi) noexcept {
  std::array<Quaternion<T>, N> q;
  if constexpr (N == 3 && std::same_as<T, double>) {
    const std::array half{Vector3<T>(phi[0] * 0.5), Vector3<T>(phi[1] * 0.5), Vector3<T>(phi[2] * 0.5)};
    const std::array angles{norm_of<T>(half[0]), norm_of<T>(half[1]), norm_of<T>(half[2])};
    const auto found = elementary::sines_cosines(angles);
    for (std::size_t k = 0; k < N; ++k) q[k] = unit_quaternion(half[k], angles[k], found[k].sine, found[k].cosine);
  } else {
    for (std::size_t k = 0; k < N; ++k) q[k] = exp<T>(phi[k]);
  }
  return q;
}

/// Rotation vector of a unit quaternion so near to -1 that the derivatives of its axis would overflow.
template <Number T>
[[nodiscard]] Vector3<T> log_near_full_turn(const Quaternion<T>& q) noexcept;

/// Rotation vector of a unit quaternion [rad, full angle]: the inverse of exp, ‖φ‖ in [0, 2π] as the sign of q says.
///
/// Never flips a sign: q with a negative scalar part has ‖φ‖ > π. At q = -1 the axis is arbitrary: x, and of a q that
/// moves there no more than its turn about that axis can be told.
/// Relative error at most 4e-16 in double, near 0, near π and beyond.
/// Source: Eberly, (12); the range is the convention of this project.
template <Number T>
[[nodiscard]] Vector3<T> log(const Quaternion<T>& q) noexcept {
  const Vector3<T> v = q.vec();
  if constexpr (std::floating_point<T>) {
    const T sine = norm_of<T>(v);
    if (sine < 4 * std::numeric_limits<T>::min())  // a full turn over it would overflow
      return q.w() < T(0) ? Vector3<T>(2 * std::numbers::pi_v<T>, T(0), T(0)) : Vector3<T>(v * T(2));
    return (2 * atan2_of(sine, q.w()) / sine) * v;
  } else {
    if (const T y = T(1.0) - q.w(); value_of(y) < 0.25) return v * (series::angle_over_sine(y) * Plain<T>(2));
    const T square = v.squaredNorm();
    if (value_of(square) < 1e-100 && value_of(q.w()) < -0.75) return log_near_full_turn(q);
    const T sine = sqrt_of(square);
    return v * (atan2_of(sine, q.w()) * Plain<T>(2) / sine);
  }
}

template <Number T>
Vector3<T> log_near_full_turn(const Quaternion<T>& q) noexcept {
  const auto plain = [](const T& x) { return static_cast<double>(value_of(x)); };
  const Vector3<double> axis =
      log<double>(Quaternion<double>(plain(q.w()), plain(q.x()), plain(q.y()), plain(q.z()))).stableNormalized();
  const Vector3<T> beyond = log<T>(Quaternion<T>(-q.w(), -q.x(), -q.y(), -q.z()));
  const T turn = beyond.x() * axis.x() + beyond.y() * axis.y() + beyond.z() * axis.z() + T(2.0 * std::numbers::pi);
  return Vector3<T>(turn * axis.x(), turn * axis.y(), turn * axis.z());
}

/// q^s = exp(s log q), the point at fraction s of the geodesic from 1 to q.
template <Number T>
[[nodiscard]] Quaternion<T> pow(const Quaternion<T>& q, const T& s) noexcept {
  return exp<T>(log(q) * s);
}

/// Increment from one orientation to the next: φ with `from · exp(φ) = to` as quaternions, ‖φ‖ ≤ 2π [rad], body frame.
///
/// Never flips a sign: keyframes that were aligned give ‖φ‖ ≤ π.
template <Number T>
[[nodiscard]] Vector3<T> increment(const Quaternion<T>& from, const Quaternion<T>& to) noexcept {
  return log<T>(from.conjugate() * to);
}

/// Geodesic distance of two orientations [rad], in [0, π]; q and -q are the same orientation.
[[nodiscard]] inline double angular_distance(const Quaternion<double>& a, const Quaternion<double>& b) noexcept {
  const Quaternion<double> d = a.conjugate() * b;
  return 2.0 * atan2_of(d.vec().norm(), std::abs(d.w()));
}

/// The vector v of the world frame in the body frame of q: R(q)ᵀ v.
template <Number T>
[[nodiscard]] Vector3<T> to_body(const Quaternion<T>& q, const Vector3<T>& v) noexcept {
  const Vector3<T> t = v.cross(q.vec()) * T(2.0);
  return v + t * q.w() + t.cross(q.vec());
}

/// The vector v of the body frame of q in the world frame: R(q) v.
template <Number T>
[[nodiscard]] Vector3<T> to_world(const Quaternion<T>& q, const Vector3<T>& v) noexcept {
  return to_body<T>(q.conjugate(), v);
}

/// Cross-product matrix: skew(a) b = a × b.
template <Number T>
[[nodiscard]] Matrix3<T> skew(const Vector3<T>& a) noexcept {
  Matrix3<T> m;
  m << T(0), -a.z(), a.y(), a.z(), T(0), -a.x(), -a.y(), a.x(), T(0);
  return m;
}

namespace jacobian {

/// I + a [φ]× + b [φ]×²
template <Number T>
[[nodiscard]] Matrix3<T> rodrigues(const Vector3<T>& phi, const T& a, const T& b) noexcept {
  const Matrix3<T> k = skew(phi);
  return Matrix3<T>::Identity() + k * a + (k * k) * b;
}

}  // namespace jacobian

/// Right Jacobian of SO(3): body rate ω = J_r(φ) φ̇ of exp(φ(t)). Accurate for every φ.
///
/// The closed form is I - (1-cos θ)/θ² [φ]× + (θ - sin θ)/θ³ [φ]×².
template <Number T>
[[nodiscard]] Matrix3<T> right_jacobian(const Vector3<T>& phi) noexcept {
  const T x = phi.squaredNorm();
  return jacobian::rodrigues<T>(phi, -series::versine_ratio(x), series::sine_defect_ratio(x));
}

/// Left Jacobian of SO(3): world rate ω_world = J_l(φ) φ̇ of exp(φ(t)); the transpose of the right one.
template <Number T>
[[nodiscard]] Matrix3<T> left_jacobian(const Vector3<T>& phi) noexcept {
  return right_jacobian<T>(-phi);
}

/// Inverse of the right Jacobian, ‖φ‖ < 2π: φ̇ = J_r⁻¹(φ) ω.
template <Number T>
[[nodiscard]] Matrix3<T> right_jacobian_inverse(const Vector3<T>& phi) noexcept {
  return jacobian::rodrigues<T>(phi, T(0.5), series::cotangent_defect_ratio(T(phi.squaredNorm())));
}

/// Inverse of the left Jacobian, ‖φ‖ < 2π.
template <Number T>
[[nodiscard]] Matrix3<T> left_jacobian_inverse(const Vector3<T>& phi) noexcept {
  return right_jacobian_inverse<T>(-phi);
}

}}  // namespace orispline
