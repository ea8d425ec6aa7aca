// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The normal equations of residuals that each involve neighbouring variables only: JᵀJ x = -Jᵀr, in a band.
class BandedSystem {
 public:
  /// Variables further apart than `band` share no residual.
  BandedSystem(std::size_t variables, std::size_t band);

  /// Adds residuals and their Jacobian by the variables of these indices, which increase.
  void add(std::span<const std::size_t> variables, const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian);

  /// The solution by LDLᵀ, in time linear in the number of variables. What the residuals do not determine stays 0, and
  /// so do the variables of `held`. The diagonal is larger by that share of it, as Levenberg and Marquardt have it.
  [[nodiscard]] std::vector<double> solved(std::span<const std::size_t> held = {}, double damping = 0.0) const;

  /// Jᵀr.
  [[nodiscard]] const std::vector<double>& gradient() const noexcept { return gradient_; }

 private:
  [[nodiscard]] double& at(std::vector<double>& matrix, std::size_t row, std::size_t column) const noexcept {
    return matrix[row * (band_ + 1) + (row - column)];
  }

  std::size_t band_;
  std::vector<double> matrix_;  ///< of every row the diagonal and the `band` columns before it
  std::vector<double> gradient_;
};

}}  // namespace orispline
