// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <vector>

#include <orispline/families/least/element.hpp>

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

/// What the iteration came to.
struct LeastOutcome {
  bool converged;
  double last_step;    ///< the largest change of a node, its rates times powers of its shorter piece [rad]
  std::size_t widest;  ///< the node that has it
  bool easy = true;    ///< steps of Gauss and Newton were enough
};

/// Steps below this end the iteration [rad]; it goes on while they get shorter.
inline constexpr double least_tolerance = 1e-9;

/// The energy of the curve through the nodes, by the rule of the elements.
[[nodiscard]] double energy_of(const LeastProblem& problem);

/// Moves the nodes to a minimum of the energy, in linear time: by steps of Gauss and Newton, where these do not soon
/// get shorter by those of Newton in a region of trust.
[[nodiscard]] LeastOutcome minimise(LeastProblem& problem);

}}}  // namespace orispline::families
