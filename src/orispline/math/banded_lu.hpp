// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A square matrix whose entries lie at most `band` places from the diagonal.
class BandedMatrix {
 public:
  BandedMatrix(std::size_t size, std::size_t band)
      : size_(size), band_(band), width_(3 * band + 1), entries_(size * width_, 0.0) {}

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t band() const noexcept { return band_; }

  /// row and column differ by no more than the band; above the diagonal there is room for twice that, which
  /// elimination with exchanges of rows fills.
  [[nodiscard]] double& operator()(std::size_t row, std::size_t column) noexcept {
    return entries_[row * width_ + band_ + column - row];
  }
  [[nodiscard]] const double& operator()(std::size_t row, std::size_t column) const noexcept {
    return entries_[row * width_ + band_ + column - row];
  }

  /// Adds a block with its first entry there.
  void add(std::size_t row, std::size_t column, const Eigen::Matrix3d& block) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        (*this)(row + i, column + k) += block(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
  }

 private:
  std::size_t size_, band_, width_;
  std::vector<double> entries_;  ///< row after row, each from `band` places before the diagonal on
};

/// The matrix AᵀA, in twice the band.
[[nodiscard]] BandedMatrix normal_matrix(const BandedMatrix& a);

/// Aᵀx
[[nodiscard]] Eigen::VectorXd transposed_product(const BandedMatrix& a, const Eigen::VectorXd& x);

/// LU decomposition with partial pivoting, in time and memory linear in the size.
class BandedLu {
 public:
  explicit BandedLu(BandedMatrix matrix);

  /// False where a column has no pivot other than zero, or one that is not a number.
  [[nodiscard]] bool regular() const noexcept { return regular_; }

  /// The solution for this right-hand side, of a regular matrix.
  [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd x) const;

 private:
  [[nodiscard]] std::size_t last_row(std::size_t column) const noexcept;
  [[nodiscard]] std::size_t end_column(std::size_t row) const noexcept;
  void bring_up_pivot(std::size_t k);

  BandedMatrix matrix_;  ///< the pivots, above them U with 1 for each, below the factors that eliminated the columns
  std::vector<std::size_t> exchanged_with_;
  std::size_t reach_;  ///< of rows of U beyond the diagonal: the band, twice that once rows were exchanged
  bool regular_ = true;
};

}}  // namespace orispline
