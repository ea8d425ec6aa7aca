// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
#include <vector>

#include <orispline/families/least_element.hpp>

namespace orispline::inline ORISPLINE_ABI::families {

/// Where a curve of least energy is at the end of a piece.
struct LeastNode {
  Eigen::Quaterniond orientation;
  ChartEnd<3> rates;  ///< ω [rad/s], α [rad/s²]
};

/// What is to be minimised: nodes, of which some unknowns are given, and the pieces between them.
struct LeastProblem {
  LeastOf of = LeastOf::acceleration;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  std::vector<LeastNode> nodes{};        ///< where the iteration starts; moved to where it ends
  std::vector<std::bitset<9>> fixed{}; ///< of each node: turn, ω and α by their components
  std::vector<double> durations{};     ///< of the pieces [s], one less
};

/// What the iteration came to.
struct LeastOutcome {
  bool converged;
  double last_step;   ///< largest change of a node, its rates times powers of its shorter piece [rad]
  std::size_t widest; ///< the node that has it
};

/// Steps below this end the iteration [rad]; it goes on while they get shorter.
inline constexpr double least_tolerance = 1e-9;

/// Moves the nodes to a minimum of the energy, in linear time: Gauss–Newton by elimination from node to node, damped by
/// Levenberg and Marquardt where a step does not make the energy less.
[[nodiscard]] LeastOutcome minimise(LeastProblem& problem);

}  // namespace orispline::inline ORISPLINE_ABI::families
