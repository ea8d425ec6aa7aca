// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far a matrix is from orthonormal: the largest element, in size, of RᵀR - 1.
[[nodiscard]] inline double orthonormality_error(const Matrix3<double>& m) noexcept {
  return (m.transpose() * m - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
}

/// The rotation that is nearest to a matrix of positive determinant by Frobenius' norm: the orthogonal factor of its
/// polar decomposition, by Newton's iteration X ← (X + X⁻ᵀ)/2, whose error squares in each step.
/// Source: Higham, Computing the polar decomposition - with applications, SIAM J. Sci. Stat. Comput. 7 (1986), sec. 3.
[[nodiscard]] inline Matrix3<double> nearest_rotation_matrix(Matrix3<double> m) noexcept {
  constexpr int most_steps = 32;
  constexpr double settled = 1e-15;
  for (int step = 0; step < most_steps; ++step) {
    Matrix3<double> cofactors;  // X⁻ᵀ times the determinant
    cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
    const Matrix3<double> next = 0.5 * (m + cofactors / m.col(0).dot(cofactors.col(0)));
    const double moved = (next - m).cwiseAbs().maxCoeff();
    m = next;
    if (!(moved > settled)) break;
  }
  return m;
}

/// Unit quaternion of a rotation matrix R_world_body that is orthonormal within rounding or nearly so, det > 0.
///
/// The component that is largest in size is positive and divides the others, so nothing small ever does.
/// Source: Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1 (1978), pp. 223-224.
[[nodiscard]] inline Eigen::Quaterniond quaternion_from_matrix(const Matrix3<double>& r) noexcept {
  const double trace = r.trace();
  Eigen::Index i = 0;
  const double largest_diagonal = r.diagonal().maxCoeff(&i);
  Eigen::Quaterniond q;
  const Eigen::Index j = (i + 1) % 3, k = (i + 2) % 3;
  if (trace >= largest_diagonal) {
    q.w() = 1.0 + trace;
    q.vec() << r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1);
  } else {
    q.w() = r(k, j) - r(j, k);
    q.vec()[i] = 1.0 + 2.0 * largest_diagonal - trace;
    q.vec()[j] = r(j, i) + r(i, j);
    q.vec()[k] = r(k, i) + r(i, k);
  }
  q.normalize();
  return q;
}

}}  // namespace orispline
