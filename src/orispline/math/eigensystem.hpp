// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The eigenvalues of a symmetric matrix, rising, and a unit eigenvector for each, by columns.
template <int N>
struct Eigensystem {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;
};

/// Of symmetric matrices of 3 rows, of 4, and of a number known at run time. Eigen's solver is slow to compile: one
/// source compiles it for all.
template <int N>
[[nodiscard]] Eigensystem<N> eigensystem(const Eigen::Matrix<double, N, N>& symmetric);

}}  // namespace orispline
