// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <orispline/math/elementary.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a chain of eliminated nodes leaves for three unknowns that all of them share: `Rows` of `Sides` right-hand
/// sides per node, the first of the data, the last three of a unit of each shared unknown.
template <int Rows, int Sides>
class BiasRows {
 public:
  void add(const Eigen::Matrix<double, Rows, Sides>& rows) {
    Eigen::Matrix<double, Rows + Sides, Sides> all;
    all << factor_, rows;
    factor_ = Eigen::HouseholderQR<decltype(all)>(all)
                  .matrixQR()
                  .template topRows<Sides>()
                  .template triangularView<Eigen::Upper>();
  }

  [[nodiscard]] Eigen::Vector3d solved() const { return decomposed().solve(factor_.col(0)); }

  /// A matrix whose product with its transpose is the covariance of the shared unknowns: the inverse of their normal
  /// matrix.
  [[nodiscard]] Eigen::Matrix3d inverse_root() const {
    const auto decomposition = decomposed();
    return decomposition.matrixV() * decomposition.singularValues().cwiseInverse().asDiagonal();
  }

  /// log det of the normal matrix of the shared unknowns.
  [[nodiscard]] double log_determinant() const {
    return 2.0 * elementary::natural_logarithm(decomposed().singularValues().prod());
  }

 private:
  /// The right-hand side stands first; its row of the factor holds columns of the unknowns too.
  [[nodiscard]] Eigen::JacobiSVD<Eigen::MatrixXd> decomposed() const {
    return Eigen::JacobiSVD<Eigen::MatrixXd>(-factor_.template rightCols<3>(),
                                             Eigen::ComputeThinU | Eigen::ComputeThinV);
  }

  Eigen::Matrix<double, Sides, Sides> factor_ = Eigen::Matrix<double, Sides, Sides>::Zero();
};

}}  // namespace orispline
