// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018: a claim of section 4, and the first question of section 5.
#include "papers/experiment.hpp"

#include <utility>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/quadrature.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

const Recipe untuned_quintic{"quintic", "quintic"};

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
                                  {"their ratio", Notation::fixed, 3},
                                  {"its maximum", Notation::fixed, 3},
                                  {"its tensions"}}};
  const auto all = models(keys);
  const auto before = curve_of(untuned_quintic, keys);
  if (!all) return tl::unexpected(all.error());
  if (!before) return tl::unexpected(before.error());
  for (const Model& model : *all) {
    const auto recipe =
        tuned(untuned_quintic, keys, {.objective = Objective::fit, .reference = {model.times, model.orientations}});
    if (!recipe) return tl::unexpected(recipe.error());
    const auto curve = curve_of(*recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    const DistanceStatistics after = distance_to(model, *curve);
    const double rms_before = distance_to(model, *before).rms;
    table.rows.push_back({model.recipe.label, degrees * rms_before, degrees * after.rms,
                          finite_or_dash(after.rms / rms_before), degrees * after.largest, text_of(recipe->tension)});
  }
  table.notes = {"The tensions are those of the least mean square of the angle to the curve, at 401 times."};
  return table;
}

const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal();  // [kg m²]

/// ∫|κ|² ds [1/rad].
double curvature_energy(const AnyCurve& curve) {
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    const KnotSpan span = curve.knots().span(i);
    const auto integrand = [&](std::span<const double> times, std::span<Figures<1>> values) {
      for (std::size_t k = 0; k < times.size(); ++k) {
        const Motion motion = curve.motion_on(i, times[k]);
        values[k] = path_shape(motion).curvature.squaredNorm() * speed(motion);
      }
    };
    sum += adaptive_integral<1>(integrand, span.start(), span.start() + span.step(), Figures<1>::Zero())[0];
  }
  return sum;
}

/// Tensions to compare, and where they are from.
struct Candidate {
  std::string which;
  Recipe recipe;
};

struct Candidates {
  std::vector<Candidate> all{};
  std::vector<std::string> notes{};  ///< of the least curvature, where these keys have none
};

/// Those of the paper, ours, and those of least energy.
Expected<Candidates> candidates(const Keyframes& keys) {
  Candidates found;
  for (const double tension : {0.35, 0.5, 0.6, 1.0})
    found.all.push_back({tension == 0.5 ? "our default" : "the paper's", {"", "quintic", {tension}}});
  for (const auto& [which, options] :
       {std::pair{"closed form", TuneOptions{.objective = Objective::linearised}},
        std::pair{"least ∫|α|² dt", TuneOptions{.objective = Objective::acceleration}},
        std::pair{"least ∫|torque|² dt", TuneOptions{.objective = Objective::torque, .inertia = inertia}},
        std::pair{"least ∫|κ|² ds", TuneOptions{.objective = Objective::curvature}}}) {
    auto recipe = tuned(untuned_quintic, keys, options);
    if (recipe) found.all.push_back({which, std::move(*recipe)});
    else if (options.objective == Objective::curvature) found.notes.push_back("κ: " + describe(recipe.error()) + ".");
    else return tl::unexpected(std::move(recipe.error()));
  }
  return found;
}

/// "How to choose the tension parameters to achieve an optimal curve in the sense of curvature/torque energy."
Expected<report::Table> best_tensions(const Keyframes& keys) {
  report::Table table{.title = "Future work: the tensions of the least energy",
                      .columns = {{"tensions"},
                                  {"which"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 3},
                                  {"∫|torque|² dt [N² m² s]", Notation::fixed, 3},
                                  {"∫|κ|² ds [1/rad]", Notation::fixed, 3}}};
  table.notes = {
      "The torque is that of a body with the principal moments 1, 2 and 2.5 kg m². κ is the curvature of the "
      "path, whatever the speed.",
      "`orispline tune` finds such tensions for keys of yours: docs/tune.md."};
  const auto found = candidates(keys);
  if (!found) return tl::unexpected(found.error());
  table.notes.insert(table.notes.end(), found->notes.begin(), found->notes.end());
  for (const auto& [which, recipe] : found->all) {
    const auto curve = curve_of(recipe, keys);
    if (!curve) return tl::unexpected(curve.error());
    const Energies energy = energies(*curve, inertia);
    const double curvature = curvature_energy(*curve);
    table.rows.push_back(
        {text_of(recipe.tension), which, energy.acceleration, energy.torque, finite_or_dash(curvature)});
  }
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
