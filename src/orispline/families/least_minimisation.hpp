// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/families/least_problem.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// What the iteration came to.
struct LeastOutcome {
  bool converged;
  double last_step;    ///< LeastStep::size [rad]
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
