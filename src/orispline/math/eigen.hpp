// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <orispline/base/abi.hpp>
#include <orispline/math/jet.hpp>

// With wider vectors, as by -mavx and -march=native, Eigen would align its types otherwise, and what holds them would
// have other sizes than in the library. (Where it knows no vectors of a processor, Eigen aligns nothing.)
#if !defined(EIGEN_ARCH_WANTS_STACK_ALIGNMENT) || EIGEN_ARCH_WANTS_STACK_ALIGNMENT
static_assert(
    alignof(Eigen::Quaterniond) == orispline::eigen_alignment,
    "orispline was compiled with Eigen's types aligned to 16 bytes (orispline::eigen_alignment, where its builder "
    "chose another number): compile with -DEIGEN_MAX_ALIGN_BYTES=16, as the CMake target orispline::orispline and "
    "pkg-config do, or build orispline with your options and ORISPLINE_EIGEN_ALIGN_BYTES");
#endif

namespace Eigen {

template <class T, int N>
struct NumTraits<orispline::Jet<T, N>> : NumTraits<T> {
  using Real = orispline::Jet<T, N>;
  using NonInteger = orispline::Jet<T, N>;
  using Nested = orispline::Jet<T, N>;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = N + 1,
    AddCost = N + 1,
    MulCost = (N + 1) * (N + 2)
  };
};

}  // namespace Eigen

namespace orispline { inline namespace ORISPLINE_ABI {

template <Number T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <Number T>
using Vector4 = Eigen::Matrix<T, 4, 1>;
template <Number T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <Number T>
using Quaternion = Eigen::Quaternion<T>;

/// Quaternion from scalar-first components (the order of this project's CSV columns `qw,qx,qy,qz`, of PX4, SPICE,
/// EuRoC).
template <Number T>
[[nodiscard]] Quaternion<T> quaternion_wxyz(T w, T x, T y, T z) {
  return Quaternion<T>(w, x, y, z);
}
/// Quaternion from scalar-first components, of any mixture of plain numbers, as in `quaternion_wxyz(1, 0, 0, 0)`.
[[nodiscard]] inline Quaternion<double> quaternion_wxyz(double w, double x, double y, double z) { return {w, x, y, z}; }

/// Quaternion from scalar-last components (the order of TUM, ROS, glTF, SciPy).
template <Number T>
[[nodiscard]] Quaternion<T> quaternion_xyzw(T x, T y, T z, T w) {
  return Quaternion<T>(w, x, y, z);
}
/// Quaternion from scalar-last components, of any mixture of plain numbers.
[[nodiscard]] inline Quaternion<double> quaternion_xyzw(double x, double y, double z, double w) { return {w, x, y, z}; }

/// A constant over another number type: every derivative is zero.
template <Number T>
[[nodiscard]] Quaternion<T> constant(const Quaternion<double>& q) {
  if constexpr (std::is_same_v<T, double>) return q;
  else return Quaternion<T>(T(q.w()), T(q.x()), T(q.y()), T(q.z()));
}
template <Number T>
[[nodiscard]] Vector3<T> constant(const Vector3<double>& v) {
  if constexpr (std::is_same_v<T, double>) return v;
  else return Vector3<T>(T(v.x()), T(v.y()), T(v.z()));
}

}}  // namespace orispline
