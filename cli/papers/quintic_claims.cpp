// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018: a claim of section 4, and the first question of section 5.
#include "papers/experiment.hpp"

#include <array>
#include <utility>

#include <orispline/analysis/energy.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {
namespace {

using report::Notation;

const Recipe quintic{"quintic", "quintic"};

/// Another scheme's curve at 401 times.
struct Model {
  Recipe recipe;
  std::vector<double> times{};
  std::vector<Eigen::Quaterniond> orientations{};
};

Expected<std::vector<Model>> models(const Keyframes& keys) {
  std::vector<Model> models{
      {{"Kim's B-spline", "bspline-through"}}, {{"Nielson's ν-spline", "nu"}}, {{"Su's ATBI, its type", "atbi"}}};
  for (Model& model : models) {
    const auto curve = curve_of(model.recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    model.times = even_times(curve->domain(), 401);
    for (const double t : model.times) model.orientations.push_back((*curve)(t));
  }
  return models;
}

DistanceStatistics distance_to(const Model& model, const AnyCurve& curve) {
  return distance_to_reference(curve, {model.times, model.orientations});
}

/// "Our quaternion curve can approximate the B-spline, ν-spline and ATBI-spline quaternion curves."
Expected<report::Table> approximations(const Keyframes& keys) {
  report::Table table{.title = "Claim: the quintic approximates other curves by its tensions",
                      .columns = {{"curve"},
                                  {"RMS with α = 0.5 [degrees]", Notation::fixed, 3},
                                  {"RMS of the nearest", Notation::fixed, 3},
                                  {"its maximum", Notation::fixed, 3},
                                  {"its tensions"}}};
  const auto all = models(keys);
  const auto before = curve_of(quintic, keys);
  if (!all) return tl::unexpected(all.error());
  if (!before) return tl::unexpected(before.error());
  for (const Model& model : *all) {
    const auto recipe =
        tuned(quintic, keys, {.objective = Objective::fit, .reference = {model.times, model.orientations}});
    if (!recipe) return tl::unexpected(recipe.error());
    const auto curve = curve_of(*recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    const DistanceStatistics after = distance_to(model, *curve);
    table.rows.push_back({model.recipe.label, degrees * distance_to(model, *before).rms, degrees * after.rms,
                          degrees * after.largest, text_of(recipe->tension)});
  }
  table.notes = {"The tensions are those of the least mean square of the angle to the curve, at 401 times."};
  return table;
}

const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal();  // [kg m²]

/// "How to choose the tension parameters to achieve an optimal curve in the sense of curvature/torque energy."
Expected<report::Table> best_tensions(const Keyframes& keys) {
  report::Table table{.title = "Future work: the tensions of the least energy",
                      .columns = {{"tensions"},
                                  {"which"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 3},
                                  {"∫|torque|² dt [N² m² s]", Notation::fixed, 3}}};
  std::vector<std::pair<std::string, Recipe>> candidates;
  for (const double tension : {0.35, 0.5, 0.6, 1.0}) candidates.push_back({"the paper's", {"", "quintic", {tension}}});
  candidates[1].first = "our default";
  for (const auto& [which, options] :
       {std::pair{"closed form", TuneOptions{.objective = Objective::linearised}},
        std::pair{"least ∫|α|² dt", TuneOptions{.objective = Objective::acceleration}},
        std::pair{"least ∫|torque|² dt", TuneOptions{.objective = Objective::torque, .inertia = inertia}}}) {
    auto recipe = tuned(quintic, keys, options);
    if (!recipe) return tl::unexpected(std::move(recipe.error()));
    candidates.push_back({which, std::move(*recipe)});
  }
  for (const auto& [which, recipe] : candidates) {
    const auto curve = curve_of(recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    const Energies energy = energies(*curve, inertia);
    table.rows.push_back({text_of(recipe.tension), which, energy.acceleration, energy.torque});
  }
  table.notes = {"The torque is that of a body with the principal moments 1, 2 and 2.5 kg m².",
                 "`orispline tune` finds such tensions for keys of yours: docs/tune.md."};
  return table;
}

}  // namespace

Expected<Findings> experiment::quintic_claims() {
  return five_keys_at({0.0, 1.0, 2.0, 3.0, 4.0}).and_then([](const Keyframes& keys) {
    return quintic_claims_on({keys, five_keys_note});
  });
}

Expected<Findings> experiment::quintic_claims_on(const KeysInstead& keys) {
  return approximations(keys.keys).and_then([&](report::Table first) {
    return best_tensions(keys.keys).map([&](report::Table second) {
      second.notes.push_back(keys.note);
      return Findings{{std::move(first), std::move(second)}};
    });
  });
}

}  // namespace orispline::cli
