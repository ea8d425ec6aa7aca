// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <orispline/math/chain_covariance.hpp>
#include <orispline/math/eigen.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// By which the derivatives of orders 0 … P-1 at the start of a step of that length [s] count at a share x of it: the
/// polynomial of degree 2P-1 that has these at its start, and none at its end. At the share 1-x, every second one with
/// the other sign, they are those of the end. Source: Stoer and Bulirsch, Numerische Mathematik 1, 2.1.5.
template <int P>
Eigen::Matrix<double, P, 1> hermite_weights(double x, double step) {
  Eigen::Matrix<double, P, 1> weights;
  double falling = 1.0;  // (1-x)^P
  for (int k = 0; k < P; ++k) falling *= 1.0 - x;
  double power = 1.0;  // (x step)^k / k!
  for (int k = 0; k < P; ++k) {
    double sum = 0.0, term = 1.0;  // C(P-1+j, j) x^j
    for (int j = 0; j < P - k; ++j) {
      sum += term;
      term *= x * (P + j) / (j + 1.0);
    }
    weights[k] = falling * power * sum;
    power *= x * step / (k + 1.0);
  }
  return weights;
}

/// The variance [rad²] that a motion of which the penalty of order P is the prior has at a share x of a step [s] whose
/// ends are known with all of their derivatives below the order P.
template <int P>
double bridge_variance(double x, double step, double lambda) {
  constexpr double divisor = P == 2 ? 3.0 : 20.0;
  double product = 1.0;  // (x (1-x) step)^(2P-1)
  for (int k = 0; k < 2 * P - 1; ++k) product *= x * (1.0 - x) * step;
  return product / (divisor * lambda);
}

/// The step behind a node: how long it is [s], and the weight of the penalty in it.
struct WeighedStep {
  double length, lambda;
};

/// What an eliminated chain leaves open of a motion, at its nodes and between them, for a penalty of order P. The first
/// 3P unknowns of every node are the turn in the body's frame, its angular velocity and, for P = 3, its acceleration.
template <int P>
class NodeVariances {
 public:
  static constexpr int size = 3 * P;
  using Block = Eigen::Matrix<double, size, size>;
  using Traces = Eigen::Matrix<double, P, P>;  // of 3x3 blocks, of derivatives of the turn in the world's frame

  /// As if nothing were shared. `rates`: of every node, ω first.
  template <class Chain, class Rates>
  NodeVariances(const Chain& chain, const std::vector<Eigen::Quaterniond>& orientations,
                const std::vector<Rates>& rates)
      : values_(orientations.size()), own_(orientations.size()), to_next_(orientations.size(), Traces::Zero()) {
    for (std::size_t i = 0; i < orientations.size(); ++i)
      to_world_.push_back(world_from(orientations[i].toRotationMatrix(), rates[i].template head<3>()));
    constexpr int all = Chain::unknowns;
    Eigen::Matrix<double, all, all> behind;
    for_each_covariance(chain, [&](std::size_t i, const auto& covariance, const auto& gain) {
      values_[i] = covariance.diagonal().template head<6>();
      own_[i] = traces_of(i, covariance.template topLeftCorner<size, size>(), i);
      if (i + 1 < to_world_.size()) {
        const Block with_next = -gain.template topRows<size>().lazyProduct(behind.template leftCols<size>());
        to_next_[i] = traces_of(i, with_next, i + 1);
      }
      behind = covariance;
    });
  }

  /// Adds what the last three right-hand sides, each a unit of a shared unknown, bring along: `root` times its
  /// transpose is the covariance of these.
  template <int M, int Data, int Sides, int Link>
  void add_shared(const ChainElimination<M, Data, Sides, Link>& chain, const Eigen::Matrix3d& root) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      Eigen::Matrix<double, Sides, 1> combination = Eigen::Matrix<double, Sides, 1>::Zero();
      combination.template tail<3>() = root.col(k);
      Eigen::Matrix<double, size, 1> behind;
      chain.solve(combination, [&](std::size_t i, const auto& x) {
        values_[i] += x.template head<6>().cwiseAbs2();
        const Eigen::Matrix<double, size, 1> here = to_world_[i].lazyProduct(x.template head<size>());
        own_[i] += traces_of(here, here);
        if (i + 1 < to_world_.size()) to_next_[i] += traces_of(here, behind);
        behind = here;
      });
    }
  }

  /// `step_of(i)`: the step behind node i, which is not the last.
  template <class StepOf>
  [[nodiscard]] NodeSigmas roots(StepOf step_of) const {
    NodeSigmas sigmas;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      sigmas.orientations.emplace_back(values_[i].template head<3>().cwiseSqrt());
      sigmas.angular_velocities.emplace_back(values_[i].template tail<3>().cwiseSqrt());
      const bool is_last = i + 1 == values_.size();
      for (std::size_t k = 1; k <= NodeSigmas::within; ++k) {
        const double x = static_cast<double>(k) / (NodeSigmas::within + 1.0);
        const double variance = is_last ? own_[i](0, 0) / 3.0 : variance_within(i, x, step_of(i));
        if (k == 1) sigmas.to_next.emplace_back();
        sigmas.to_next.back()[k - 1] = std::sqrt(std::max(0.0, variance));
      }
    }
    return sigmas;
  }

 private:
  /// The derivatives θ, θ', … of the turn in the world from the unknowns: θ = R δ, θ' = R δω, θ'' = R (δα + ω × δω).
  static Block world_from(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& rate) {
    Block block = Block::Zero();
    for (int k = 0; k < P; ++k) block.template block<3, 3>(3 * k, 3 * k) = rotation;
    if constexpr (P == 3) block.template block<3, 3>(6, 3) = rotation * skew(rate);
    return block;
  }

  [[nodiscard]] Traces traces_of(std::size_t i, const Block& covariance, std::size_t j) const {
    const Block left = to_world_[i].lazyProduct(covariance);
    const Block world = left.lazyProduct(to_world_[j].transpose());
    Traces traces;
    for (int k = 0; k < P; ++k)
      for (int l = 0; l < P; ++l) traces(k, l) = world.template block<3, 3>(3 * k, 3 * l).trace();
    return traces;
  }

  static Traces traces_of(const Eigen::Matrix<double, size, 1>& a, const Eigen::Matrix<double, size, 1>& b) {
    Traces traces;
    for (int k = 0; k < P; ++k)
      for (int l = 0; l < P; ++l) traces(k, l) = a.template segment<3>(3 * k).dot(b.template segment<3>(3 * l));
    return traces;
  }

  /// Per axis, at a share x of the step behind node i.
  [[nodiscard]] double variance_within(std::size_t i, double x, const WeighedStep& step) const {
    const Eigen::Matrix<double, P, 1> from = hermite_weights<P>(x, step.length);
    Eigen::Matrix<double, P, 1> to = hermite_weights<P>(1.0 - x, step.length);
    for (int k = 1; k < P; k += 2) to[k] = -to[k];
    const double of_ends = from.dot(own_[i] * from) + 2.0 * from.dot(to_next_[i] * to) + to.dot(own_[i + 1] * to);
    return of_ends / 3.0 + bridge_variance<P>(x, step.length, step.lambda);
  }

  std::vector<Eigen::Matrix<double, 6, 1>> values_;  // of turn and angular velocity
  std::vector<Block> to_world_;
  std::vector<Traces> own_, to_next_;
};

}}  // namespace orispline
