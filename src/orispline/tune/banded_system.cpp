// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/banded_system.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A pivot that is less than this share of its diagonal is rounding.
constexpr double singular = 1e-14;

}  // namespace

BandedSystem::BandedSystem(std::size_t variables, std::size_t band)
    : band_(band), matrix_(variables * (band + 1), 0.0), gradient_(variables, 0.0) {}

void BandedSystem::add(std::span<const std::size_t> variables, const Eigen::VectorXd& residuals,
                       const Eigen::MatrixXd& jacobian) {
  for (std::size_t a = 0; a < variables.size(); ++a) {
    const auto column = jacobian.col(static_cast<Eigen::Index>(a));
    gradient_[variables[a]] += column.dot(residuals);
    for (std::size_t b = 0; b <= a; ++b)
      at(matrix_, variables[a], variables[b]) += column.dot(jacobian.col(static_cast<Eigen::Index>(b)));
  }
}

std::vector<double> BandedSystem::solved(std::span<const std::size_t> held, double damping) const {
  std::vector<double> factor = matrix_, x(gradient_.size());
  for (std::size_t i = 0; i < x.size(); ++i) at(factor, i, i) *= 1.0 + damping;
  std::vector<bool> stays(x.size(), false);
  for (const std::size_t variable : held) stays[variable] = true;
  const auto first_of = [this](std::size_t row) { return row > band_ ? row - band_ : 0; };
  for (std::size_t i = 0; i < x.size(); ++i) {
    double pivot = at(factor, i, i), sum = -gradient_[i];
    const double diagonal = pivot;
    for (std::size_t j = first_of(i); j < i; ++j) {
      if (stays[j]) continue;
      double& entry = at(factor, i, j);
      for (std::size_t k = std::max(first_of(i), first_of(j)); k < j; ++k)
        if (!stays[k]) entry -= at(factor, i, k) * at(factor, j, k) * at(factor, k, k);
      const double product = entry;
      entry /= at(factor, j, j);
      pivot -= product * entry;
      sum -= entry * x[j];
    }
    at(factor, i, i) = pivot;
    x[i] = sum;
    stays[i] = stays[i] || !(pivot > singular * diagonal);
  }
  for (std::size_t i = x.size(); i-- > 0;) {
    x[i] = stays[i] ? 0.0 : x[i] / at(factor, i, i);
    for (std::size_t j = i + 1; j < std::min(x.size(), i + band_ + 1); ++j)
      if (!stays[i]) x[i] -= at(factor, j, i) * x[j];
  }
  return x;
}

}}  // namespace orispline
