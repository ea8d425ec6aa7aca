// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/analysis/compared_keys.hpp>

#include "papers/experiment.hpp"
#include "papers/recipe.hpp"

namespace orispline::cli {

/// Five keys and the truth between them: the first turn of the bundled flight, from straight to straight flight.
[[nodiscard]] Expected<Flight> first_turn();
[[nodiscard]] Expected<Flight> whole_flight();

/// Keys of one's own, with what a recording has between the first and the last of them. Rates that it does not have are
/// those of `auto` through it. Error (bad_data): that curve's.
[[nodiscard]] Expected<Flight> flight_of(const ComparedData& data, std::string name);

/// The truth as keys, for a page that shows it.
[[nodiscard]] Keyframes truth_of(const Flight& flight);

/// Figures 1 to 6 of the 6th degree on a flight: the curves of figures 2 to 6, then all of figure 1.
[[nodiscard]] std::vector<Picture> flight_pictures(const Flight& flight, const std::vector<Served>& drawn,
                                                   const std::vector<Served>& framed);

}  // namespace orispline::cli
