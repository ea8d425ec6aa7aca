// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/batch/kernel/trigonometry.hpp>

// Vectors and quaternions in registers for the kernel's loops. In an anonymous namespace, so that every instruction set
// has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

template <class T>
struct Vector {
  T x, y, z;
};
template <class T>
[[gnu::always_inline]] inline Vector<T> vector(const T (&v)[3]) {
  return {v[0], v[1], v[2]};
}
template <class T>
[[gnu::always_inline]] inline Vector<T> operator+(Vector<T> a, Vector<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
[[gnu::always_inline]] inline Vector<T> operator-(Vector<T> a, Vector<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
[[gnu::always_inline]] inline Vector<T> operator*(T s, Vector<T> a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
[[gnu::always_inline]] inline T dot(Vector<T> a, Vector<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
[[gnu::always_inline]] inline Vector<T> cross(Vector<T> a, Vector<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Angular velocity, acceleration and jerk of a sample.
template <class T>
struct BodyRates {
  Vector<T> omega, alpha, jerk;
};

/// exp of a half rotation vector v times s by even series: neither root nor division.
template <class T>
struct Turn {
  T w, x, y, z;
};
template <class T>
[[gnu::always_inline]] inline Turn<T> turn(const T* v, std::size_t plane, T s) {
  const T x = v[0] * s, y = v[plane] * s, z = v[2 * plane] * s;
  const T u = x * x + y * y + z * z;
  const T sinc = T(1) + u * polynomial(Series<T>::sin_wide, u);
  return {T(1) + u * polynomial(Series<T>::cos_wide, u), sinc * x, sinc * y, sinc * z};
}
template <class T>
[[gnu::always_inline]] inline Turn<T> operator*(Turn<T> a, Turn<T> b) {
  return {(a.w * b.w - a.x * b.x) - (a.y * b.y + a.z * b.z), (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z), (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x)};
}

}  // namespace

}}}  // namespace orispline::batch
