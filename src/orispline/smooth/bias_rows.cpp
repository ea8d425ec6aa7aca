// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/bias_rows.hpp>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Decomposition = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// The right-hand side stands first; its row of the factor holds columns of the unknowns too.
template <int Sides>
Decomposition decomposed(const Eigen::Matrix<double, Sides, Sides>& factor) {
  return Decomposition(-factor.template rightCols<3>(), Eigen::ComputeThinU | Eigen::ComputeThinV);
}

}  // namespace

template <int Rows, int Sides>
void BiasRows<Rows, Sides>::add(const Eigen::Matrix<double, Rows, Sides>& rows) {
  Eigen::Matrix<double, Rows + Sides, Sides> all;
  all << factor_, rows;
  factor_ = Eigen::HouseholderQR<decltype(all)>(all)
                .matrixQR()
                .template topRows<Sides>()
                .template triangularView<Eigen::Upper>();
}

template <int Rows, int Sides>
Eigen::Vector3d BiasRows<Rows, Sides>::solved() const {
  return decomposed(factor_).solve(factor_.col(0));
}

template <int Rows, int Sides>
Eigen::Matrix3d BiasRows<Rows, Sides>::inverse_root() const {
  const Decomposition decomposition = decomposed(factor_);
  return decomposition.matrixV() * decomposition.singularValues().cwiseInverse().asDiagonal();
}

template <int Rows, int Sides>
double BiasRows<Rows, Sides>::log_determinant() const {
  return 2.0 * elementary::natural_logarithm(decomposed(factor_).singularValues().prod());
}

template class BiasRows<12, 4>;
template class BiasRows<15, 4>;

}}  // namespace orispline
