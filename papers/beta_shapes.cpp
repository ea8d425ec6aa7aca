// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, section 5: "the spline shape can be controlled locally" by β₁ and β₂. Which are best?
#include <array>
#include <optional>
#include <utility>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/flight.hpp"
#include "papers/recipe.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

struct ShapeChoice {
  const char* which;
  std::optional<TuneOptions> options{};  ///< absent: β₁ = 1 and β₂ = 0 at every key, as they are
};

/// `beta-g2` in the form that passes through the keys.
Method through_keys() { return {"beta-g2", {.choices = {{"form", "global"}}}}; }

Expected<Method> chosen(const Method& method, const ShapeChoice& choice, const Keyframes& keys) {
  if (!choice.options) return method;
  return tune(keys, method, *choice.options).map([](const Tuning& tuning) { return tuning.method; });
}

std::string values_of(const Method& method, const char* parameter) {
  const auto found = method.options.parameters.find(parameter);
  if (found == method.options.parameters.end()) return "as it is";
  return text_of(found->second);
}

Expected<report::Table> best_shapes(const Flight& flight) {
  report::Table table{.title = "The best β₁ and β₂, " + flight.name,
                      .columns = {{"method"},
                                  {"β₁ and β₂"},
                                  {"β₁"},
                                  {"β₂"},
                                  {"shape"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 4},
                                  {"RMS [degrees]", Notation::fixed, 2},
                                  {"maximum", Notation::fixed, 2}}};
  const std::array choices{
      ShapeChoice{"as they are"}, ShapeChoice{"both, of least energy", TuneOptions{}},
      ShapeChoice{"β₂ nearest to the truth", TuneOptions{.objective = Objective::fit,
                                                         .reference = {flight.times, flight.orientations},
                                                         .parameters = {"beta2"}}}};
  for (const Method& untuned : {Method("beta-through"), through_keys()})
    for (const ShapeChoice& choice : choices) {
      const auto method = chosen(untuned, choice, flight.keys);
      if (!method) return tl::unexpected(method.error());
      const auto curve = make_curve(*method, flight.keys);
      if (!curve) return tl::unexpected(curve.error());
      const DistanceStatistics distance = distance_to_reference(*curve, {flight.times, flight.orientations});
      table.rows.push_back({method->name, choice.which, values_of(*method, "beta1"), values_of(*method, "beta2"),
                            measured_shape(*curve), energies(*curve).acceleration, degrees * distance.rms,
                            degrees * distance.largest});
    }
  table.notes = {
      "As they are: β₁ = 1, β₂ = 0. `beta-g2` is its form `global`, which passes through the keys as `beta-through` "
      "does.",
      "With β₁ free as well no curve is the nearest: the nearer it is, the nearer β are to values that no curve has.",
      "`beta` passes its keys by and has less energy the less it turns, so that no β are those of the least."};
  return table;
}

}  // namespace

Expected<Findings> experiment::beta_shapes() { return first_turn().and_then(beta_shapes_on); }

Expected<Findings> experiment::beta_shapes_on(const Flight& flight) {
  return best_shapes(flight).map([&](report::Table table) {
    if (!flight.note.empty()) table.notes.push_back(flight.note);
    return Findings{{std::move(table)}};
  });
}

}  // namespace orispline::cli
