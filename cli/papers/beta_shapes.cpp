// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, section 5: "the spline shape can be controlled locally" by β₁ and β₂. Which are best?
#include <cmath>
#include <utility>

#include <orispline/analysis/distance.hpp>
#include <orispline/analysis/energy.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/flight.hpp"
#include "papers/recipe.hpp"

namespace orispline::cli {
namespace {

using report::Notation;

struct Choice {
  const char* which;
  std::optional<TuneOptions> options{};  ///< absent: β₁ = 1 and β₂ = 0 at every key, as they are
};

/// `beta-g2` in the form that passes through the keys.
Method through_keys() { return {"beta-g2", {.choices = {{"form", "global"}}}}; }

Expected<Method> chosen(const Method& method, const Choice& choice, const Keyframes& keys) {
  if (!choice.options) return method;
  return tune(keys, method, *choice.options).map([](const Tuning& tuning) { return tuning.method; });
}

std::string values_of(const Method& method, const char* parameter) {
  const auto found = method.options.parameters.find(parameter);
  if (found == method.options.parameters.end()) return "as it is";
  std::vector<double> rounded = found->second;
  for (double& value : rounded)
    if (std::abs(value) < 1e-4) value = 0.0;  // a β₁ that is as small as it may be
  return text_of(rounded);
}

struct Row {
  Method method;
  std::vector<Choice> choices;
};

Expected<report::Table> best_shapes(const std::string& title, const Flight& flight, bool with_beta) {
  report::Table table{.title = "The best β₁ and β₂, " + title,
                      .columns = {{"method"},
                                  {"β₁ and β₂"},
                                  {"β₁"},
                                  {"β₂"},
                                  {"shape"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 4},
                                  {"RMS [degrees]", Notation::fixed, 2},
                                  {"maximum", Notation::fixed, 2}}};
  const Choice plain{"as they are"}, by_energy{"of least energy", TuneOptions{}},
      by_fit{"nearest to the truth",
             TuneOptions{.objective = Objective::fit, .reference = {flight.times, flight.orientations}}};
  std::vector<Row> rows{{"beta-through", {plain, by_energy, by_fit}}, {through_keys(), {plain, by_energy, by_fit}}};
  if (with_beta) rows.insert(rows.begin(), {"beta", {plain, by_fit}});
  for (const auto& [untuned, choices] : rows)
    for (const Choice& choice : choices) {
      const auto method = chosen(untuned, choice, flight.keys);
      if (!method) return tl::unexpected(method.error());
      const auto curve = make_curve(*method, flight.keys);
      if (!curve) return tl::unexpected(curve.error());
      const DistanceStatistics distance = distance_to_reference(*curve, {flight.times, flight.orientations});
      table.rows.push_back({method->name, choice.which, values_of(*method, "beta1"), values_of(*method, "beta2"),
                            measured_shape(*curve), energies(*curve).acceleration, degrees * distance.rms,
                            degrees * distance.largest});
    }
  return table;
}

}  // namespace

Expected<Findings> experiment::beta_shapes() {
  const auto five = first_turn(), all = whole_flight();
  if (!five) return tl::unexpected(five.error());
  if (!all) return tl::unexpected(all.error());
  auto turn = best_shapes("five keys of the flight's first turn", *five, true);
  auto flight = best_shapes("all 38 keys of the flight", *all, false);
  if (!turn) return tl::unexpected(std::move(turn.error()));
  if (!flight) return tl::unexpected(std::move(flight.error()));
  flight->notes = {
      "As they are: β₁ = 1, β₂ = 0. `beta-g2` is its form `global`, which passes through the keys as `beta-through` "
      "does.",
      "`beta` passes its keys by and has less energy the less it turns, so that no β are those of the least."};
  return Findings{{std::move(*turn), std::move(*flight)}};
}

}  // namespace orispline::cli
