// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>

#include "papers/experiment.hpp"
#include "papers/recipe.hpp"

namespace orispline::cli {

/// A true motion, sampled, and keys taken from it.
struct Flight {
  std::vector<double> times;
  std::vector<Motion> truth;
  std::vector<Eigen::Quaterniond> orientations;
  Keyframes keys;
};

/// Five keys and the truth between them: the first turn of the bundled flight, from straight to straight flight.
[[nodiscard]] Expected<Flight> first_turn();
[[nodiscard]] Expected<Flight> whole_flight();

/// The truth as keys, for a page that shows it.
[[nodiscard]] Keyframes truth_of(const Flight& flight);

/// Figures 1 to 6 of the 6th degree on a flight: the curves of figures 2 to 6, then all of figure 1.
[[nodiscard]] std::vector<Picture> flight_pictures(const Flight& flight, const std::vector<Served>& drawn,
                                                   const std::vector<Served>& framed);

}  // namespace orispline::cli
