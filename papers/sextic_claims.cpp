// SPDX-License-Identifier: Apache-2.0
// The 6th degree: a claim of section 4.1, and the future work of section 5.
#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/flight.hpp"
#include "papers/sampling.hpp"
#include "papers/sextic_qualities.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

constexpr std::size_t enough_frames = 20'001;  // for the clock to see them
constexpr auto timed_note = "On uneven keys `timed-sextic` is the same curve made continuous in time.";

/// "Our method runs faster than Tan's on the basis of higher continuity, and is slightly slower than Xing's."
report::Table times_table(const Flight& flight) {
  struct Printed {
    Recipe recipe;
    const char* seconds;
  };
  const std::array all{Printed{{"Xing, quartic", "xing-quartic"}, "0.540154"},
                       Printed{{"Tan, α = 0.45", "quintic", {0.45}}, "0.738309"},
                       Printed{{"6th degree, β = 0.025", "sextic", {0.025}}, "0.715989"}};
  const auto keys = flight.keys.times();
  const auto times = even_times({keys.front(), keys.back()}, enough_frames);
  std::vector<std::function<void()>> works;
  works.reserve(all.size());
  for (const Printed& printed : all) works.push_back(building(printed.recipe, flight.keys, times));
  const auto seconds = seconds_in_turn(works);
  report::Table table{.title = "Claim: faster than Tan's quintic, slightly slower than Xing's quartic",
                      .columns = {{"curve"}, {"method"}, {"time [ms]", Notation::fixed, 3}, {"paper: time [s]"}}};
  for (std::size_t i = 0; i < all.size(); ++i)
    table.rows.push_back({all[i].recipe.label, all[i].recipe.method, 1e3 * seconds[i], all[i].seconds});
  table.notes = {
      formatted(
          "Processor times of the curve through {} and 20 001 orientations: medians of nine rounds on this machine, "
          "in each of which the three take turns.",
          flight.name),
      "The three differ in the degree of three polynomials only; the products of quaternions take the time."};
  return table;
}

/// "The quantitative analysis, so as to propose the optimal parameter value scheme."
Expected<report::Table> best_tensions(const Flight& flight, const std::vector<const char*>& methods,
                                      const std::string& note) {
  report::Table table{.title = "Future work: the best β, " + flight.name,
                      .columns = {{"method"},
                                  {"β"},
                                  {"continuity"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 4},
                                  {"RMS [degrees]", Notation::fixed, 2},
                                  {"maximum", Notation::fixed, 2}}};
  const TuneOptions by_fit{.objective = Objective::fit, .reference = {flight.times, flight.orientations}};
  for (const char* method : methods) {
    const Recipe plain{"1/12, as it is", method};
    auto by_energy = tuned({"of least energy", method}, flight.keys, {}),
         nearest = tuned({"nearest to the truth", method}, flight.keys, by_fit);
    if (!by_energy) return tl::unexpected(std::move(by_energy.error()));
    if (!nearest) return tl::unexpected(std::move(nearest.error()));
    const auto curves = curves_through(flight.keys, {plain, std::move(*by_energy), std::move(*nearest)});
    if (!curves) return tl::unexpected(curves.error());
    for (const auto& [recipe, curve] : *curves) {
      const DistanceStatistics distance = distance_to_reference(curve, {flight.times, flight.orientations});
      table.rows.push_back({recipe.method, recipe.label, measured_continuity(curve),
                            energies(curve, Eigen::Matrix3d::Identity()).acceleration, degrees * distance.rms,
                            degrees * distance.largest});
    }
  }
  table.notes = {note};
  return table;
}

}  // namespace

Expected<Findings> experiment::sextic_claims() {
  const auto five = first_turn(), all = whole_flight();
  if (!five) return tl::unexpected(five.error());
  if (!all) return tl::unexpected(all.error());
  auto turn = best_tensions(*five, {"sextic"},
                            "The least energy leads away from the truth: it lets the aircraft turn at the ends, where "
                            "it is at rest.");
  auto flight = best_tensions(*all, {"sextic", "timed-sextic"}, timed_note);
  if (!turn) return tl::unexpected(std::move(turn.error()));
  if (!flight) return tl::unexpected(std::move(flight.error()));
  return sextic_qualities(*five).map([&](std::vector<report::Table> tables) {
    Findings findings{{times_table(*five), std::move(*turn), std::move(*flight)}};
    std::ranges::move(tables, std::back_inserter(findings.tables));
    return findings;
  });
}

Expected<Findings> experiment::sextic_claims_on(const Flight& flight) {
  return best_tensions(flight, {"sextic", "timed-sextic"}, timed_note).map([&](report::Table best) {
    best.notes.push_back(flight.note);
    return Findings{{times_table(flight), std::move(best)}};
  });
}

}  // namespace orispline::cli
