// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/scalar_link.hpp>
#include <orispline/smooth/smoothing_loss.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The spline for a penalty of order P: its value and P-1 derivatives at every node, in three columns for the axes.
template <int P>
class PositionSpline {
 public:
  PositionSpline(const SmoothingProblem& problem, const SmoothingObjective& objective)
      : problem_(problem), objective_(objective) {}

  [[nodiscard]] SmoothingFit run(const SmoothingIteration& iteration, const SmoothedNodes* start) {
    SmoothingFit fit;
    if (start) fit.nodes.positions = start->positions;
    weigh(fit);
    for (fit.iterations = 1;; ++fit.iterations) {
      const bool first = fit.nodes.positions.empty();
      const std::vector<Eigen::Vector3d> before = std::move(fit.nodes.positions);
      solve(fit);
      weigh(fit);
      if (objective_.work) objective_.work->add(static_cast<double>(problem_.size()));
      fit.last_step = 0.0;  // of squares one step is the whole way
      if (objective_.loss == LossFunction::l2 || objective_.stopped()) break;
      fit.last_step = first ? std::numeric_limits<double>::infinity() : largest_move(before, fit.nodes.positions);
      if (fit.last_step < iteration.tolerance || fit.iterations >= iteration.most) break;
    }
    fit.cost = fit.data + objective_.lambda * fit.penalty;
    return fit;
  }

 private:
  using Node = Eigen::Matrix<double, P, 3>;
  using Chain = ChainElimination<P, 1, 3>;

  /// With the root of its share of λ.
  [[nodiscard]] Eigen::Matrix<double, P, 2 * P> link(std::size_t i) const {
    return std::sqrt(problem_.relative_lambda(i)) * scalar_link<P>(problem_.times[i + 1] - problem_.times[i]);
  }

  static double largest_move(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to) {
    double largest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) largest = std::max(largest, (to[i] - from[i]).norm());
    return largest;
  }

  /// Residuals, and what the loss leaves of their weights; without positions as of squares.
  void weigh(SmoothingFit& fit) const {
    fit.loss_weights.assign(problem_.size(), 1.0);
    if (fit.nodes.positions.empty()) return;
    fit.data = 0.0;
    fit.residuals.assign(problem_.size(), Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (!(problem_.weights[i] > 0.0)) continue;
      fit.residuals[i] = problem_.positions[i] - fit.nodes.positions[i];
      const LossValue loss =
          loss_at(objective_.loss, problem_.weights[i] * fit.residuals[i].squaredNorm(), objective_.threshold);
      fit.loss_weights[i] = loss.weight;
      fit.data += loss.value;
    }
  }

  /// The positions of the least cost with these weights, and their penalty.
  void solve(SmoothingFit& fit) {
    chain_.start(problem_.size());
    const double root = std::sqrt(objective_.lambda);
    for (std::size_t i = 0; i < problem_.size() && !objective_.stopped(); ++i) {
      typename Chain::Low low = Chain::Low::Zero();
      low(0, 0) = std::sqrt(problem_.weights[i] * fit.loss_weights[i]);
      low.template block<1, 3>(0, 2 * P) = low(0, 0) * problem_.positions[i].transpose();
      if (i + 1 < problem_.size()) low.template bottomLeftCorner<P, 2 * P>() = root * link(i);
      static_cast<void>(chain_.add(low));
    }
    std::vector<Node> nodes(problem_.size(), Node::Zero());
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      chain_.solve(Eigen::Vector3d::Unit(axis), [&](std::size_t i, const auto& x) { nodes[i].col(axis) = x; });
    fit.nodes.positions.clear();
    fit.penalty = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      fit.nodes.positions.emplace_back(nodes[i].row(0).transpose());
      if (i + 1 == nodes.size()) break;
      Eigen::Matrix<double, 2 * P, 3> both;
      both << nodes[i], nodes[i + 1];
      fit.penalty += (link(i) * both).squaredNorm();
    }
  }

  const SmoothingProblem& problem_;
  const SmoothingObjective& objective_;
  Chain chain_;  // kept for its memory
};

}  // namespace

SmoothingFit fit_positions(const SmoothingProblem& problem, const SmoothingObjective& objective,
                           const SmoothingIteration& iteration, const SmoothedNodes* start) {
  return objective.penalty == Penalty::acceleration ? PositionSpline<2>(problem, objective).run(iteration, start)
                                                    : PositionSpline<3>(problem, objective).run(iteration, start);
}

}}  // namespace orispline
