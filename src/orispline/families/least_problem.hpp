// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/families/least_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Where a curve of least energy is at the end of a piece.
struct LeastNode {
  Eigen::Quaterniond orientation;
  ChartEnd<3> rates;  ///< ω [rad/s], α [rad/s²]
};

/// What is to be minimised: nodes, of which some unknowns are given, and the pieces between them.
struct LeastProblem {
  LeastOf of = LeastOf::acceleration;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  std::vector<LeastNode> nodes{};       ///< where the iteration starts; moved to where it ends
  std::vector<std::bitset<9>> fixed{};  ///< of each node: turn, ω and α by their components
  std::vector<double> durations{};      ///< of the pieces [s], one less

  [[nodiscard]] Eigen::Vector3d increment_after(std::size_t node) const {
    return increment<double>(nodes[node].orientation, nodes[node + 1].orientation);
  }
  [[nodiscard]] double shorter_piece_beside(std::size_t node) const {
    return std::min(durations[node > 0 ? node - 1 : 0], durations[node < durations.size() ? node : node - 1]);
  }
};

/// How the nodes are to be moved: turns as q exp(x), ω and α by sums.
struct LeastStep {
  std::vector<Eigen::Matrix<double, 9, 1>> nodes{};
  double size = 0.0;       ///< largest change of a node, its rates times powers of its shorter piece [rad]
  std::size_t widest = 0;  ///< the node that has it

  LeastStep() = default;
  LeastStep(const LeastProblem& problem, std::vector<Eigen::Matrix<double, 9, 1>> moves) : nodes(std::move(moves)) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double h = problem.shorter_piece_beside(i);
      const double change =
          nodes[i].head<3>().norm() + h * nodes[i].segment<3>(3).norm() + h * h * nodes[i].tail<3>().norm();
      if (change <= size) continue;  // not where it is NaN, which then stays
      size = change;
      widest = i;
    }
  }
};

/// The step of Gauss and Newton from the present nodes, by elimination from node to node.
template <LeastOf F>
[[nodiscard]] LeastStep gauss_newton_step(const LeastProblem& problem);

/// The equations of Newton's method with all second derivatives at the present nodes, damped as by
/// Levenberg and Marquardt: symmetric, with a block for each node and one to the next.
class LeastNewton {
 public:
  template <LeastOf F>
  [[nodiscard]] static LeastNewton at(const LeastProblem& problem);

  struct Step {
    LeastStep step;
    double gain;  ///< by which the energy would fall if it were of second order
  };
  /// Absent where the damped Hessian is not positive definite.
  [[nodiscard]] std::optional<Step> step(const LeastProblem& problem, double damping) const;

 private:
  using Block = Eigen::Matrix<double, 9, 9>;
  using Move = Eigen::Matrix<double, 9, 1>;
  std::vector<Block> blocks_{}, links_{};
  std::vector<Move> sides_{};
  std::vector<Eigen::Array3d> weights_{};
};

}}}  // namespace orispline::families
