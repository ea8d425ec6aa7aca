// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/eigensystem.hpp>

#include <Eigen/Eigenvalues>

namespace orispline { inline namespace ORISPLINE_ABI {

template <int N>
Eigensystem<N> eigensystem(const Eigen::Matrix<double, N, N>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template Eigensystem<3> eigensystem(const Eigen::Matrix3d&);
template Eigensystem<4> eigensystem(const Eigen::Matrix4d&);
template Eigensystem<Eigen::Dynamic> eigensystem(const Eigen::MatrixXd&);

}}  // namespace orispline
