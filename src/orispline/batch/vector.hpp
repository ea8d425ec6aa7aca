// SPDX-License-Identifier: Apache-2.0
#pragma once

// Vectors in registers for the kernel's loops. In an anonymous namespace, so that every instruction set has its own.

namespace orispline::batch {
namespace {

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

}  // namespace
}  // namespace orispline::batch
