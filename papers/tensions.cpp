// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, figures 2 and 3.
#include "papers/experiment.hpp"

#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>

#include "papers/example_data.hpp"
#include "papers/frames.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;

const std::vector<double> even{0.0, 1.0, 2.0, 3.0, 4.0};
constexpr std::array curve_colors{color::grey, color::blue, color::red, color::green, color::purple, color::gold};

report::SpherePicture paths_of(const std::vector<Served>& curves, const Keyframes& keys) {
  report::SpherePicture picture;
  for (const Served& served : curves)
    picture.paths.push_back({axis_path(served.curve, even_times(served.curve.domain(), 401), Eigen::Vector3d::UnitX()),
                             served.recipe.stroke});
  for (const Eigen::Vector3d& x : axis_path(keys.orientations(), Eigen::Vector3d::UnitX()))
    picture.dots.push_back({x, std::to_string(picture.dots.size() + 1)});
  return picture;
}

/// Figure 2: all tensions 0.35 but that of key 3.
std::vector<Recipe> with_tension_of_key3(std::initializer_list<double> values) {
  std::vector<Recipe> recipes;
  for (const double value : values)
    recipes.push_back({formatted("α₃ = {:g}", value),
                       "quintic",
                       {0.35, 0.35, value, 0.35, 0.35},
                       {curve_colors[recipes.size()], 2.0}});
  return recipes;
}

report::Table one_tension_table(const std::vector<Served>& curves, const AnyCurve& base) {
  report::Table table{.title = "How far the curve moves when the tension of key 3 is not 0.35: largest angle [degrees]",
                      .columns = {{"tensions"}}};
  for (int segment = 1; segment <= 4; ++segment)
    table.columns.push_back({formatted("segment {}", segment), Notation::fixed, 4});
  table.columns.push_back({"|ω| at key 3 [rad/s]", Notation::fixed, 4});
  table.columns.push_back({"|α| at key 3 [rad/s²]", Notation::fixed, 4});
  for (const Served& served : curves) {
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{text_of(served.recipe.tension)});
    for (std::size_t i = 0; i + 1 < even.size(); ++i)
      row.emplace_back(degrees * largest_distance(served.curve, base, even_times({even[i], even[i + 1]}, 101)));
    const Motion at_key = served.curve.motion(even[2]);
    row.emplace_back(speed(at_key));
    row.emplace_back(acceleration(at_key));
  }
  table.notes = {
      "One tension changes the two segments beside its key and no others.",
      "At the key ω = α (a + b)/h, so a tension of 0 makes a stop and a negative one a kink, as the paper says.",
      five_keys_note};
  return table;
}

/// Figure 3: the three schemes it compares with, then the quintic with the tension vectors of (e) to (j), one of which
/// is for five keys.
std::vector<Recipe> schemes_of_figure3(std::size_t keys) {
  const std::vector<double> five{0.1, 0.6, 0.0, 0.6, 0.1};
  const auto all = [keys](double value) { return std::vector<double>(keys, value); };
  std::vector<Recipe> schemes{{"B-spline", "bspline-through", {}, {"#b4b4b4", 4.5}},
                              {"ν = 0", "nu", {}, {color::sky}},
                              {"ATBI type", "atbi", {}, {color::ink}},
                              {"α = 0.35", "quintic", all(0.35), {color::blue}},
                              {"α = 0.6", "quintic", all(0.6), {color::red}},
                              {"α = 0.1, 0.6, 0, 0.6, 0.1", "quintic", five, {color::green}},
                              {"α = 1", "quintic", all(1.0), {color::purple}},
                              {"α = 2", "quintic", all(2.0), {color::gold}},
                              {"α = 0", "quintic", all(0.0), {color::frame}}};
  if (keys != five.size()) std::erase_if(schemes, [&](const Recipe& scheme) { return scheme.tension == five; });
  return schemes;
}

report::Table motions_table(const std::vector<Served>& curves, const KeysInstead& keys) {
  report::Table table{.title = "The rotations of figure 3 (b) to (j)",
                      .columns = {{"curve"},
                                  {"method"},
                                  {"continuity"},
                                  {"largest |ω| [rad/s]", Notation::fixed, 3},
                                  {"largest |α| [rad/s²]", Notation::fixed, 3},
                                  {"|ω| at key 3 [rad/s]", Notation::fixed, 3}}};
  for (const Served& served : curves)
    table.rows.push_back({served.recipe.label, served.recipe.method, measured_continuity(served.curve),
                          largest_over_time(served.curve, speed), largest_over_time(served.curve, acceleration),
                          speed(served.curve.motion(keys.keys.times()[2]))});
  table.notes = {"Continuity is in time and measured at the keys. With α = 0 every key is a stop.",
                 "We could not get the ATBI paper; this is a curve of its type (docs/families/atbi.md).", keys.note};
  return table;
}

/// Figure 3: 17 bodies on a straight line per curve, the keys green and the new ones red.
Picture frames(const std::vector<Served>& curves, const Keyframes& keys) {
  std::vector<FrameRow> rows;
  for (const auto& [recipe, curve] : curves)
    rows.push_back(frames_of(recipe.label, curve, even_times(curve.domain(), 17), keys.times(),
                             {.key = color::green, .between = color::red}));
  report::Drawing drawing(860, 20.0 + frame_row_height * static_cast<double>(rows.size()));
  draw_frames(drawing, 11.0, rows);
  return {"000-figure3", std::move(drawing)};
}

using Figure = std::function<double(const Motion&)>;

report::Chart chart_of(const std::string& title, std::span<const Served> curves, const Figure& figure,
                       std::span<const double> knots) {
  report::Chart chart{.title = title, .series = {}, .marks = marks_at(knots)};
  for (const auto& [recipe, curve] : curves) {
    chart.series.push_back(over_time(curve, figure));
    chart.series.back().label = recipe.label;
    chart.series.back().stroke = recipe.stroke;
  }
  return chart;
}

/// Over time: the four schemes of (b), (c), (d) and (f), then the tensions of (e) to (j).
Picture rates(const std::vector<Served>& curves, std::span<const double> knots) {
  const std::vector<Served> schemes{curves[0], curves[1], curves[2], curves[4]};
  const auto tensions = std::span(curves).subspan(3);
  report::Drawing drawing(860, 740);
  double top = 58.0;
  for (const report::Chart& chart :
       {chart_of("angular velocity |ω| [rad/s] of the schemes", schemes, speed, knots),
        chart_of("angular acceleration |α| [rad/s²]", schemes, acceleration, knots),
        chart_of("angular velocity |ω| [rad/s] for six tension vectors", tensions, speed, knots)}) {
    report::draw_legend(drawing, {50.0, top - 34.0}, chart.series);
    report::draw(drawing, {50.0, top, 780.0, 160.0}, chart);
    top += 250.0;
  }
  return {"000-figure3-rates", std::move(drawing)};
}

}  // namespace

Expected<Findings> experiment::one_tension() {
  const auto keys = five_keys_at(even);
  if (!keys) return tl::unexpected(keys.error());
  auto recipes = with_tension_of_key3({0.35, 0.0, 0.7, 1.0, 2.0});
  auto negative = with_tension_of_key3({0.35, -0.35, -0.7, -1.0, -2.0});
  const auto upper = curves_through(*keys, std::move(recipes)), lower = curves_through(*keys, std::move(negative));
  if (!upper) return tl::unexpected(upper.error());
  if (!lower) return tl::unexpected(lower.error());
  std::vector<Served> all = *upper;
  all.insert(all.end(), lower->begin() + 1, lower->end());
  report::Drawing drawing(860, 430);
  const report::View view = report::facing(axis_path(keys->orientations(), Eigen::Vector3d::UnitX()));
  double x = 215.0;
  for (const auto* curves : {&*upper, &*lower}) {
    std::vector<report::Series> legend;
    for (const Served& served : *curves) legend.push_back({served.recipe.label, {}, {}, served.recipe.stroke});
    report::draw_legend(drawing, {x - 195.0, 18.0}, std::span(legend).first(3));
    report::draw_legend(drawing, {x - 195.0, 38.0}, std::span(legend).subspan(3));
    report::draw(drawing, view, {x, 240.0}, 175.0, paths_of(*curves, *keys));
    x += 430.0;
  }
  return Findings{
      {one_tension_table(all, upper->front().curve)}, {{"000-figure2", std::move(drawing)}}, motions_of(all, *keys)};
}

Expected<Findings> experiment::rigid_motions() {
  return five_keys_at(even).and_then([](const Keyframes& keys) { return rigid_motions_of({keys, five_keys_note}); });
}

Expected<Findings> experiment::rigid_motions_of(const KeysInstead& keys) {
  return curves_through(keys.keys, schemes_of_figure3(keys.keys.size())).map([&](const std::vector<Served>& curves) {
    return Findings{{motions_table(curves, keys)},
                    {frames(curves, keys.keys), rates(curves, keys.keys.times())},
                    motions_of(curves, keys.keys)};
  });
}

}  // namespace orispline::cli
