// SPDX-License-Identifier: Apache-2.0
// The 6th degree: table 1.
#include <functional>
#include <utility>

#include <orispline/analysis/distance.hpp>
#include <orispline/base/formatted.hpp>

#include "papers/flight.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;

/// What the paper prints for a method.
struct PrintedMethod {
  Recipe recipe;
  std::string degree, mse, largest, seconds;
};

std::vector<PrintedMethod> printed_methods() {
  const std::string none = "–";
  return {{{"Xing, quartic", "xing-quartic", {}, {color::sky, 1.8}}, "4", "0.012979", "0.256878", "0.540154"},
          {{"Xing, quintic", "xing-quintic"}, "5", none, none, none},
          {{"Tan, α = 0.45", "quintic", {0.45}, {color::red, 1.8}}, "5", "0.011337", "0.188917", "0.738309"},
          {{"Tan, α = 0.6", "quintic", {0.6}}, "5", none, none, none},
          {{"6th degree, β = 0.025", "sextic", {0.025}, {color::purple, 1.8}}, "6", "0.001130", "0.079421", "0.715989"},
          {{"6th degree, β = 0.05", "sextic", {0.05}, {color::gold, 1.8}}, "6", none, none, none},
          {{"6th degree, β = 5/96", "sextic", {5.0 / 96.0}, {color::green, 1.8, "6 5"}}, "6", none, none, none},
          {{"6th degree, β = 1/12", "sextic", {1.0 / 12.0}, {color::blue, 1.8}}, "6", none, none, none},
          {{"timed-c3", "timed-c3"}, "7", none, none, none},
          {{"auto", "auto"}, "5", none, none, none}};
}

/// MSE and maximum of the angle between curve and truth, then of their distance on the sphere of unit quaternions.
std::vector<report::Cell> distances_of(const AnyCurve& curve, const Flight& flight) {
  const DistanceStatistics angle = distance_to_reference(curve, {flight.times, flight.orientations});
  constexpr double half = 0.5;  // of the angle is the arc between the quaternions: spherical_distance()
  return {angle.mean_square(), angle.largest, half * half * angle.mean_square(), half * angle.largest};
}

std::vector<report::Column> distance_columns() {
  return {{"angle: MSE [rad²]", Notation::fixed, 6},
          {"angle: maximum [rad]", Notation::fixed, 6},
          {"sphere: MSE [rad²]", Notation::fixed, 6},
          {"sphere: maximum [rad]", Notation::fixed, 6}};
}

constexpr auto distances_note =
    "Angle: that of the rotation between curve and truth. Sphere: the arc between their unit quaternions, which is "
    "half "
    "of it.";

/// Times to build the curves and to compute their orientations at every time of the truth [s].
std::vector<double> seconds_of(const std::vector<PrintedMethod>& methods, const Flight& flight) {
  std::vector<std::function<void()>> works;
  works.reserve(methods.size());
  for (const PrintedMethod& method : methods) works.push_back(building(method.recipe, flight.keys, flight.times));
  return seconds_in_turn(works);
}

Expected<report::Table> comparison(const std::string& title, const Flight& flight) {
  report::Table table{.title = title, .columns = {{"curve"}, {"method"}, {"degree"}, {"in time"}, {"in shape"}}};
  for (const report::Column& column : distance_columns()) table.columns.push_back(column);
  table.columns.push_back({"time [ms]", Notation::fixed, 3});
  const auto methods = printed_methods();
  const auto seconds = seconds_of(methods, flight);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Recipe& recipe = methods[i].recipe;
    const auto curve = curve_of(recipe, flight.keys);
    if (!curve) return tl::unexpected(curve.error());
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{recipe.label, recipe.method, methods[i].degree,
                                                                  measured_continuity(*curve), measured_shape(*curve)});
    const auto distances = distances_of(*curve, flight);
    row.insert(row.end(), distances.begin(), distances.end());
    row.emplace_back(1e3 * seconds[i]);
  }
  return table;
}

constexpr auto unknown_distance_note =
    "The paper says \"spherical distance\". Its flight is not published and this is the bundled simulation, so that "
    "the numbers cannot tell which of the two it means.";
constexpr auto xing_note =
    "The paper says C3 for the quartic, which is C2, and gives the quartic's name to the quintic, its own curve at β = "
    "5/96.";
constexpr auto small_note =
    "In the paper a small β is the best. Here it is not: its curve slows down at every key, and the aircraft does not.";
constexpr auto measured_note =
    "Continuity is measured at the keys, C in time and G of the path. Processor times of the curve and 961 "
    "orientations on this machine, medians of rounds in which the rows take turns.";

void add_printed_figures(report::Table& table) {
  table.columns.insert(table.columns.end(), {{"paper: MSE"}, {"paper: maximum"}, {"paper: time [s]"}});
  const auto printed = printed_methods();
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].insert(table.rows[i].end(), {printed[i].mse, printed[i].largest, printed[i].seconds});
  table.notes = {distances_note,
                 unknown_distance_note,
                 "Both are taken at the 961 times of the truth. The degree is that of the blending.",
                 measured_note,
                 xing_note,
                 small_note};
}

/// Ends at rest, as the aircraft is, and tensions that were found: without the truth by the least energy, with it by
/// the least distance.
Expected<std::vector<Recipe>> better_methods(const Flight& flight) {
  std::vector<Recipe> recipes{
      {.label = "global-c2", .method = "global-c2", .ends = "rest"},
      {.label = "Tan, α = 0.45", .method = "quintic", .tension = {0.45}, .ends = "rest"},
      {.label = "Tan, α = 0.6", .method = "quintic", .tension = {0.6}, .ends = "rest"},
      {.label = "6th degree, β = 0.025", .method = "sextic", .tension = {0.025}, .ends = "rest"},
      {.label = "6th degree, β = 1/12", .method = "sextic", .tension = {1.0 / 12.0}, .ends = "rest"}};
  const TuneOptions by_fit{.objective = Objective::fit, .reference = {flight.times, flight.orientations}};
  for (const auto& [found_by, options] : {std::pair{"by energy", TuneOptions{}}, std::pair{"by fit", by_fit}})
    for (const auto& [name, method] : {std::pair{"Tan", "quintic"}, std::pair{"6th degree", "sextic"}})
      for (const char* ends : {"repeat", "rest"}) {
        auto recipe =
            tuned({.label = formatted("{}, {}", name, found_by), .method = method, .ends = ends}, flight.keys, options);
        if (!recipe) return tl::unexpected(std::move(recipe.error()));
        recipes.push_back(std::move(*recipe));
      }
  return recipes;
}

Expected<report::Table> better_table(const Flight& flight) {
  return better_methods(flight)
      .and_then([&](std::vector<Recipe> recipes) { return curves_through(flight.keys, std::move(recipes)); })
      .map([&](const std::vector<Served>& curves) {
        report::Table table{.title = "The same keys: ends at rest, and tensions found by energy and by fit",
                            .columns = {{"curve"}, {"ends"}, {"tensions"}}};
        for (const report::Column& column : distance_columns()) table.columns.push_back(column);
        for (const auto& [recipe, curve] : curves) {
          auto& row =
              table.rows.emplace_back(std::vector<report::Cell>{recipe.label, recipe.ends, text_of(recipe.tension)});
          const auto distances = distances_of(curve, flight);
          row.insert(row.end(), distances.begin(), distances.end());
        }
        table.notes = {
            "By energy: least ∫|α|² dt, which needs the keys only. By fit: least MSE, which needs the truth."};
        return table;
      });
}

/// The curves with a colour are in figures 2 to 6; all of the papers are in figure 1.
std::vector<Recipe> drawn_methods() {
  std::vector<Recipe> recipes;
  for (PrintedMethod& method : printed_methods())
    if (method.recipe.stroke.color != color::ink) recipes.push_back(std::move(method.recipe));
  return recipes;
}

/// (c) to (h) of figure 1.
std::vector<Recipe> framed_methods() {
  return {{"Tan, α = 0.6", "quintic", {0.6}},   {"Xing, quartic", "xing-quartic"},
          {"β = 0.025", "sextic", {0.025}},     {"β = 0.05", "sextic", {0.05}},
          {"β = 5/96", "sextic", {5.0 / 96.0}}, {"β = 1/12", "sextic", {1.0 / 12.0}}};
}

}  // namespace

Expected<Findings> experiment::flight_compared() {
  const auto five = first_turn(), all = whole_flight();
  if (!five) return tl::unexpected(five.error());
  if (!all) return tl::unexpected(all.error());
  auto even = comparison("Five keys, 2.4 s apart, of the bundled flight's first turn (2.6 to 12.2 s)", *five);
  auto better = better_table(*five);
  auto uneven = comparison("The whole bundled flight: 38 keys at uneven times", *all);
  const auto drawn = curves_through(five->keys, drawn_methods()), framed = curves_through(five->keys, framed_methods());
  for (const auto* table : {&even, &better, &uneven})
    if (!*table) return tl::unexpected(table->error());
  for (const auto* curves : {&drawn, &framed})
    if (!*curves) return tl::unexpected(curves->error());
  add_printed_figures(*even);
  better->notes.insert(better->notes.begin(),
                       "The aircraft rests at both ends. Ends at rest say so; the papers' rule, repeat, halves the "
                       "speed of the chord there.");
  uneven->notes = {"This is not in the paper. On uneven knots its curves are continuous in shape, not in time."};
  return Findings{{std::move(*even), std::move(*better), std::move(*uneven)},
                  flight_pictures(*five, *drawn, *framed),
                  motions_of(*drawn, five->keys),
                  truth_of(*five)};
}

Expected<Findings> experiment::flight_compared_on(const Flight& flight) {
  auto compared = comparison("The curves of table 1, " + flight.name, flight);
  auto better = better_table(flight);
  const auto drawn = curves_through(flight.keys, drawn_methods()),
             framed = curves_through(flight.keys, framed_methods());
  for (const auto* table : {&compared, &better})
    if (!*table) return tl::unexpected(table->error());
  for (const auto* curves : {&drawn, &framed})
    if (!*curves) return tl::unexpected(curves->error());
  compared->notes = {distances_note, flight.note};
  return Findings{{std::move(*compared), std::move(*better)},
                  flight_pictures(flight, *drawn, *framed),
                  motions_of(*drawn, flight.keys),
                  truth_of(flight)};
}

}  // namespace orispline::cli
