// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, table 1.
#include "papers/experiment.hpp"

#include <algorithm>
#include <functional>

#include <orispline/base/formatted.hpp>

#include "papers/example_data.hpp"
#include "papers/fixed_points.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

/// A row of the paper's table; the recognised text has two of its rows mixed up, the numbers follow their order.
struct PrintedRow {
  Recipe recipe;
  std::size_t frames;
  std::string seconds, iterations, error, construction;
};

std::vector<PrintedRow> printed_table() {
  const Recipe bspline{"Kim's B-spline", "bspline-through"}, nu{"Nielson's ν-spline", "nu"},
      atbi{"Su's ATBI, its type", "atbi"}, quintic{"Tan's quintic, α = 0.6", "quintic", {0.6}};
  const std::string formula = "explicit formula", geometry = "geometric";
  return {{bspline, 401, "0.360815", "13", "1e-6", formula}, {bspline, 17, "0.355337", "13", "1e-6", formula},
          {nu, 401, "6.744356", "27", "1e-6", geometry},     {nu, 17, "0.859442", "27", "1e-6", geometry},
          {atbi, 401, "0.087366", "–", "–", formula},        {atbi, 17, "0.086153", "–", "–", formula},
          {quintic, 401, "0.087444", "–", "–", formula},     {quintic, 17, "0.085934", "–", "–", formula}};
}

constexpr auto times_note =
    "Processor times of the curve and the orientations of all frames: medians of nine rounds on this machine, in each "
    "of which the rows take turns.";

/// Times to build the curves and to compute their frames [s].
std::vector<double> seconds_of(const std::vector<PrintedRow>& rows, const Keyframes& keys) {
  const Domain domain{keys.times().front(), keys.times().back()};
  std::vector<std::vector<double>> times;
  times.reserve(rows.size());
  for (const PrintedRow& row : rows) times.push_back(even_times(domain, row.frames));
  std::vector<std::function<void()>> works;
  works.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) works.push_back(building(rows[i].recipe, keys, times[i]));
  return seconds_in_turn(works);
}

double error_at_keys(const AnyCurve& curve, const Keyframes& keys) {
  double largest = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i)
    largest = std::max(largest, angular_distance(curve(keys.times()[i]), keys.orientations()[i]));
  return largest;
}

/// The number of sweeps, or that there is none.
report::Cell cell_of(std::optional<std::size_t> sweeps) {
  if (sweeps) return static_cast<double>(*sweeps);
  return formatted("more than {}", most_sweeps);
}

/// The published iterations, counted.
report::Table iterations_table(const Keyframes& keys) {
  report::Table table{.title = "Iterations from the keys to the paper's 1e-6",
                      .columns = {{"scheme"},
                                  {"one iteration"},
                                  {"ends"},
                                  {"until within 1e-6 rad of the keys"},
                                  {"until no control moves by 1e-6 rad"},
                                  {"paper: iterations"}}};
  const auto add = [&](const char* scheme, const char* iteration, const char* ends, const Sweeps& sweeps,
                       const char* printed) {
    table.rows.push_back({scheme, iteration, ends, cell_of(sweeps.until_near), cell_of(sweeps.until_still), printed});
  };
  const auto by_error = "every control turns by the error at its key", by_more = "by 1.5 times the error",
             by_neighbours = "every control from its neighbours";
  add("Kim's B-spline", by_error, "natural", bspline_sweeps(keys, 1.0), "13");
  add("Kim's B-spline", by_more, "natural", bspline_sweeps(keys, 1.5), "13");
  add("Nielson's ν-spline", by_neighbours, "natural", nu_sweeps(keys, NuEnds::natural), "27");
  add("Nielson's ν-spline", by_neighbours, "rest", nu_sweeps(keys, NuEnds::rest), "27");
  table.notes = {
      "The iterations are run here only. The library solves the same equations by Newton's method, to 1e-12 rad.",
      "The paper states neither its ends nor what its 1e-6 is measured of, and we have not read Kim's text."};
  return table;
}

}  // namespace

Expected<Findings> experiment::schemes_compared() {
  return five_keys_at({0.0, 1.0, 2.0, 3.0, 4.0}).and_then([](const Keyframes& keys) {
    return schemes_compared_on({keys, five_keys_note});
  });
}

Expected<Findings> experiment::schemes_compared_on(const KeysInstead& given) {
  const Keyframes& keys = given.keys;
  const std::string count = keys.size() == 5 ? "Five" : std::to_string(keys.size());
  report::Table table{.title = count + " keys to 401 and 17 frames; on the right what the paper prints",
                      .columns = {{"scheme"},
                                  {"method"},
                                  {"continuity"},
                                  {"frames"},
                                  {"time [ms]", Notation::fixed, 4},
                                  {"error [rad]", Notation::scientific, 1},
                                  {"construction"},
                                  {"paper: time [s]"},
                                  {"paper: iterations"},
                                  {"paper: error"}}};
  const auto printed = printed_table();
  const auto seconds = seconds_of(printed, keys);
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const PrintedRow& row = printed[i];
    const auto curve = curve_of(row.recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    table.rows.push_back({row.recipe.label, row.recipe.method, measured_continuity(*curve),
                          static_cast<double>(row.frames), 1e3 * seconds[i], error_at_keys(*curve, keys),
                          row.construction, row.seconds, row.iterations, row.error});
  }
  table.notes = {
      times_note, "The error is the largest angle between the curve and a key at the key's time.",
      "Iterations and error on the right are the paper's. Its two global schemes are solved to 1e-12 rad here.",
      "We could not get the ATBI paper; this is a curve of its type (docs/families/atbi.md).", given.note};
  return Findings{{std::move(table), iterations_table(keys)}};
}

}  // namespace orispline::cli
