// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/so3.hpp>

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

}}  // namespace orispline
