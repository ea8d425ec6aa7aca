// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <orispline/math/eigensystem.hpp>
#include <orispline/smooth/smoothing_loss.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Tukey's loss counts nothing from here on, in σ: 95 % efficient for three numbers.
inline constexpr double rejected_from = 6.0;

/// A residual, and how it changes with the unknowns.
template <int Unknowns>
struct Linear {
  Eigen::Vector3d value;
  Eigen::Matrix<double, 3, Unknowns> slopes;
};

/// Weighted normal equations, and what blocks of successive samples add to the gradient: their scatter is that of the
/// residuals, however these hang together.
template <int Unknowns>
struct RobustEquations {
  using Vector = Eigen::Matrix<double, Unknowns, 1>;
  using Matrix = Eigen::Matrix<double, Unknowns, Unknowns>;

  Matrix matrix = Matrix::Zero();
  Vector gradient = Vector::Zero();
  Matrix scatter = Matrix::Zero();
  Vector of_block = Vector::Zero();        // the gradient of the block that is not ended
  double weights = 0.0, curvatures = 0.0;  // sums of ρ′ and of the mean second derivative

  void add(const Linear<Unknowns>& linear, double sigma) {
    const double square = linear.value.squaredNorm() / (sigma * sigma);
    const double weight = loss_at(LossFunction::tukey, square, rejected_from).weight;
    const double bound = rejected_from * rejected_from, rest = std::max(0.0, 1.0 - square / bound);
    const Vector slope = weight / (sigma * sigma) * (linear.slopes.transpose() * linear.value);
    matrix += weight / (sigma * sigma) * (linear.slopes.transpose() * linear.slopes);
    gradient += slope;
    of_block += slope;
    weights += weight;
    curvatures += weight - 4.0 / 3.0 * rest * square / bound;
  }

  void end_block() {
    scatter += of_block * of_block.transpose();
    of_block.setZero();
  }
};

/// How many successive samples share a block.
[[nodiscard]] inline std::size_t samples_in_block(std::size_t samples) {
  constexpr std::size_t most_blocks = 50, least_in_block = 10, enough_for_blocks = 100;
  return samples < enough_for_blocks ? 1 : std::max(samples / most_blocks, least_in_block);
}

/// The inverse of the normal matrix where it says something, in units; directions without an answer are open: a step of
/// one unit would move the samples by less than their noise.
template <int Unknowns>
struct NormalInverse {
  using Vector = Eigen::Matrix<double, Unknowns, 1>;

  Eigen::Matrix<double, Unknowns, Unknowns> matrix = Eigen::Matrix<double, Unknowns, Unknowns>::Zero();
  std::vector<Vector> open{};  // of length 1 in the units

  NormalInverse(const Eigen::Matrix<double, Unknowns, Unknowns>& normal, const Vector& units,
                const std::vector<Eigen::Index>& free, std::size_t samples) {
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd scaled(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index k = 0; k < count; ++k)
        scaled(i, k) = normal(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(k)]) *
                       units[free[static_cast<std::size_t>(i)]] * units[free[static_cast<std::size_t>(k)]];
    const auto eigen = eigensystem<Eigen::Dynamic>(scaled);
    for (Eigen::Index e = 0; e < count; ++e) {
      Vector direction = Vector::Zero();
      for (Eigen::Index i = 0; i < count; ++i)
        direction[free[static_cast<std::size_t>(i)]] = eigen.vectors(i, e) * units[free[static_cast<std::size_t>(i)]];
      if (const double value = eigen.values[e]; value > static_cast<double>(samples))
        matrix += direction * direction.transpose() / value;
      else open.push_back(direction);
    }
  }
};

/// (Σ ρ″)⁻¹ (scatter of the gradient) (Σ ρ″)⁻¹, of as many samples as there are beside the unknowns.
template <int Unknowns>
[[nodiscard]] Eigen::Matrix<double, Unknowns, Unknowns> covariance_of(const RobustEquations<Unknowns>& equations,
                                                                      const NormalInverse<Unknowns>& inverse,
                                                                      std::size_t samples, std::size_t unknowns) {
  const double curvature = std::max(equations.curvatures / std::max(equations.weights, 1e-300), 0.1);
  const double numbers = 3.0 * static_cast<double>(samples);
  const double few = numbers / std::max(1.0, numbers - static_cast<double>(unknowns));
  return few / (curvature * curvature) * (inverse.matrix * equations.scatter * inverse.matrix);
}

}}  // namespace orispline
