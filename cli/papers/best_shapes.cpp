// SPDX-License-Identifier: Apache-2.0
// He et al. 2022: the shape parameters of its curves that are best by energy and by fit.
#include <algorithm>
#include <utility>

#include <orispline/analysis/distance.hpp>
#include <orispline/analysis/energy.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/flight.hpp"

namespace orispline::cli {
namespace {

using report::Notation;

/// Which of the parameters are sought, and how.
struct Way {
  std::string name;
  TuneOptions options;
};

/// With β = (1, 0), and with what the ways find.
struct Shapes {
  std::vector<std::pair<std::string, Method>> all;
};

Expected<Shapes> shapes_of(const Method& method, const Keyframes& keys, const std::vector<Way>& ways) {
  Shapes shapes{{{"β = (1, 0)", method}}};
  for (const Way& way : ways) {
    auto tuning = tune(keys, method, way.options);
    if (!tuning) return tl::unexpected(std::move(tuning.error()));
    shapes.all.emplace_back(way.name, std::move(tuning->method));
  }
  return shapes;
}

/// The values of one of them; a dash where it stays at its default.
std::string text_of_parameter(const Method& method, std::string_view name) {
  const auto found = method.options.parameters.find(name);
  return found == method.options.parameters.end() ? "–" : text_of(found->second);
}

std::vector<Method> beta_methods() {
  Method global("beta-g2");
  global.options.choices["form"] = "global";
  return {"beta", "beta-through", "beta-g2", global};
}

std::string name_of(const Method& method) {
  return method.options.choices.empty() ? std::string(method.name) : std::string(method.name) + ", global";
}

Way least_energy(const std::vector<std::string>& free) {
  return {free.size() == 1 ? "β₂ of least ∫|α|² dt" : "β₁ and β₂ of least ∫|α|² dt", {.parameters = free}};
}

Expected<report::Table> best_by_energy(const Keyframes& keys) {
  report::Table table{
      .title = "The β of least energy, five keys at even times",
      .columns = {{"method"}, {"β"}, {"β₁"}, {"β₂"}, {"continuity"}, {"∫|α|² dt [rad²/s³]", Notation::fixed, 3}}};
  for (const Method& method : beta_methods()) {
    const auto shapes = shapes_of(method, keys, {least_energy({"beta2"})});
    if (!shapes) return tl::unexpected(shapes.error());
    for (const auto& [which, shape] : shapes->all) {
      const auto curve = make_curve(shape, keys);
      if (!curve) return tl::unexpected(curve.error());
      table.rows.push_back({name_of(method), which, text_of_parameter(shape, "beta1"),
                            text_of_parameter(shape, "beta2"), measured_continuity(*curve),
                            energies(*curve, Eigen::Matrix3d::Identity()).acceleration});
    }
  }
  table.notes = {
      "The energies are of curves that begin and end elsewhere: `beta` and `beta-g2` run from near the "
      "second key to near the last but one.",
      "β₁ stays 1: it is the ratio of the speeds after and before a key, and such jumps cost no energy."};
  return table;
}

Expected<report::Table> best_by_fit(const Flight& flight) {
  report::Table table{.title = "The β nearest to the truth, all 38 keys of the flight",
                      .columns = {{"method"},
                                  {"β"},
                                  {"β₁"},
                                  {"β₂"},
                                  {"∫|α|² dt [rad²/s³]", Notation::fixed, 2},
                                  {"RMS [degrees]", Notation::fixed, 2},
                                  {"maximum", Notation::fixed, 2}}};
  const auto fit = [&](const std::vector<std::string>& free) {
    return TuneOptions{
        .objective = Objective::fit, .reference = {flight.times, flight.orientations}, .parameters = free};
  };
  const std::vector<Way> ways{least_energy({"beta2"}), {"β₂ nearest to the truth", fit({"beta2"})}};
  for (const Method& method : beta_methods()) {
    const auto shapes = shapes_of(method, flight.keys, ways);
    if (!shapes) return tl::unexpected(shapes.error());
    for (const auto& [which, shape] : shapes->all) {
      const auto curve = make_curve(shape, flight.keys);
      if (!curve) return tl::unexpected(curve.error());
      const DistanceStatistics distance = distance_to_reference(*curve, {flight.times, flight.orientations});
      table.rows.push_back({name_of(method), which, text_of_parameter(shape, "beta1"),
                            text_of_parameter(shape, "beta2"),
                            energies(*curve, Eigen::Matrix3d::Identity()).acceleration, degrees * distance.rms,
                            degrees * distance.largest});
    }
  }
  table.notes = {"Distances are those to the truth at its times on the curve. The keys are uneven, so the rate jumps."};
  return table;
}

}  // namespace

Expected<Findings> experiment::best_shapes() {
  const auto keys = five_keys_at({0.0, 1.0, 2.0, 3.0, 4.0});
  const auto flight = whole_flight();
  if (!keys) return tl::unexpected(keys.error());
  if (!flight) return tl::unexpected(flight.error());
  auto by_energy = best_by_energy(*keys), by_fit = best_by_fit(*flight);
  if (!by_energy) return tl::unexpected(std::move(by_energy.error()));
  if (!by_fit) return tl::unexpected(std::move(by_fit.error()));
  return Findings{{std::move(*by_energy), std::move(*by_fit)}};
}

}  // namespace orispline::cli
