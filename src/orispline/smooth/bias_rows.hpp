// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a chain of eliminated nodes leaves for three unknowns that all of them share: `Rows` of `Sides` right-hand
/// sides per node, the first of the data, the last three of a unit of each shared unknown. For 12 and 15 rows of 4
/// sides.
template <int Rows, int Sides>
class BiasRows {
 public:
  void add(const Eigen::Matrix<double, Rows, Sides>& rows);

  [[nodiscard]] Eigen::Vector3d solved() const;

  /// A matrix whose product with its transpose is the covariance of the shared unknowns: the inverse of their normal
  /// matrix.
  [[nodiscard]] Eigen::Matrix3d inverse_root() const;

  /// log det of the normal matrix of the shared unknowns.
  [[nodiscard]] double log_determinant() const;

 private:
  Eigen::Matrix<double, Sides, Sides> factor_ = Eigen::Matrix<double, Sides, Sides>::Zero();
};

}}  // namespace orispline
