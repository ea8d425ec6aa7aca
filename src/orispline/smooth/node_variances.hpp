// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/chain_covariance.hpp>
#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The variances of turn and angular velocity at every node of an eliminated chain, the first six unknowns of each.
class NodeVariances {
 public:
  /// As if nothing were shared.
  template <class Chain>
  explicit NodeVariances(const Chain& chain) : values_(chain.rows().size()) {
    for_each_covariance(chain, [this](std::size_t i, const auto& covariance, const auto&) {
      values_[i] = covariance.diagonal().template head<6>();
    });
  }

  /// Adds what the last three right-hand sides, each a unit of a shared unknown, bring along: `root` times its
  /// transpose is the covariance of these.
  template <int M, int Data, int Sides, int Link>
  void add_shared(const ChainElimination<M, Data, Sides, Link>& chain, const Eigen::Matrix3d& root) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      Eigen::Matrix<double, Sides, 1> combination = Eigen::Matrix<double, Sides, 1>::Zero();
      combination.template tail<3>() = root.col(k);
      chain.solve(combination,
                  [this](std::size_t i, const auto& x) { values_[i] += x.template head<6>().cwiseAbs2(); });
    }
  }

  [[nodiscard]] NodeSigmas roots() const {
    NodeSigmas sigmas;
    for (const auto& value : values_) {
      sigmas.orientations.emplace_back(value.template head<3>().cwiseSqrt());
      sigmas.angular_velocities.emplace_back(value.template tail<3>().cwiseSqrt());
    }
    return sigmas;
  }

 private:
  std::vector<Eigen::Matrix<double, 6, 1>> values_;
};

}}  // namespace orispline
