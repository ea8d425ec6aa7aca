// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, figures 2 and 3.
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>

#include <orispline/analysis/continuity.hpp>
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

constexpr double usual = 0.35;  // of all keys but the third
constexpr std::size_t third = 2;

/// Figure 2: all tensions as usual but that of key 3.
Recipe with_tension_of_key3(double value, std::size_t keys, std::string_view stroke) {
  std::vector<double> tensions(keys, usual);
  tensions[third] = value;
  return {formatted("α₃ = {:g}", value), "quintic", std::move(tensions), {stroke, 2.0}};
}

std::vector<Recipe> with_tensions_of_key3(std::initializer_list<double> values, std::size_t keys) {
  std::vector<Recipe> recipes;
  for (const double value : values) recipes.push_back(with_tension_of_key3(value, keys, curve_colors[recipes.size()]));
  return recipes;
}

/// The curves of figure 2, the first of both with all tensions as usual.
struct Figure2 {
  std::vector<Served> positive, negative;
  Served zero;  ///< all tensions 0
};

Expected<Figure2> curves_of_figure2(const Keyframes& keys) {
  const std::size_t n = keys.size();
  return curves_through(keys, with_tensions_of_key3({usual, 0.0, 0.7, 1.0, 2.0}, n)).and_then([&](auto positive) {
    return curves_through(keys, with_tensions_of_key3({usual, -0.35, -0.7, -1.0, -2.0}, n))
        .and_then([&](auto negative) {
          const Recipe zero{"α = 0", "quintic", std::vector(n, 0.0), {color::sky, 2.0, "5 4"}};
          return curve_of(zero, keys).map([&](AnyCurve curve) {
            return Figure2{std::move(positive), std::move(negative), {zero, std::move(curve)}};
          });
        });
  });
}

std::vector<double> moved_by_segment(const AnyCurve& curve, const AnyCurve& base, std::span<const double> knots) {
  std::vector<double> moved;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    moved.push_back(degrees * largest_distance(curve, base, even_times({knots[i], knots[i + 1]}, 101)));
  return moved;
}

/// All its tensions, where there are few.
std::string name_of(const Recipe& recipe) { return recipe.tension.size() > 8 ? recipe.label : text_of(recipe.tension); }

report::Table one_tension_table(const std::vector<Served>& curves, const KeysInstead& keys) {
  constexpr std::size_t most_segments = 4;  // of those that one tension may move, and their neighbours
  const auto knots = keys.keys.times();
  const std::size_t shown = std::min(most_segments, knots.size() - 1);
  report::Table table{.title = "How far the curve moves when the tension of key 3 is not 0.35: largest angle [degrees]",
                      .columns = {{"tensions"}}};
  for (std::size_t segment = 1; segment <= shown; ++segment)
    table.columns.push_back({formatted("segment {}", segment), Notation::fixed, 4});
  if (knots.size() - 1 > shown) table.columns.push_back({"all others", Notation::fixed, 4});
  table.columns.push_back({"|ω| at key 3 [rad/s]", Notation::fixed, 4});
  table.columns.push_back({"|α| at key 3 [rad/s²]", Notation::fixed, 4});
  for (const Served& served : curves) {
    const std::vector<double> moved = moved_by_segment(served.curve, curves.front().curve, knots);
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{name_of(served.recipe)});
    row.insert(row.end(), moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(shown));
    if (moved.size() > shown)
      row.emplace_back(*std::max_element(moved.begin() + static_cast<std::ptrdiff_t>(shown), moved.end()));
    const Motion at_key = served.curve.motion(knots[third]);
    row.emplace_back(speed(at_key));
    row.emplace_back(acceleration(at_key));
  }
  table.notes = {
      "One tension changes the two segments beside its key and no others. The last row has all tensions 0.",
      "At the key ω = α (a + b)/h, so a tension of 0 makes a stop and a negative one a kink, as the paper says.",
      keys.note};
  return table;
}

/// "The larger the absolute value of a tension is, the flatter the shape of the curve around the corresponding knot."
Expected<report::Table> flatness_table(const Keyframes& keys) {
  constexpr std::size_t most_keys = 3;
  const auto knots = keys.times();
  const std::size_t shown = std::min(most_keys, knots.size() - 2);
  report::Table table{
      .title = "The larger |α|, the flatter: the curvature of the path at a key with that tension [1/rad]",
      .columns = {{"α"}}};
  for (std::size_t key = 1; key <= shown; ++key)
    table.columns.push_back({formatted("at key {}", key + 1), Notation::fixed, 3});
  for (const double value : {0.1, 0.2, 0.35, 0.7, 1.0, 2.0, -0.1, -0.35, -1.0, -2.0}) {
    const auto curve = curve_of({"", "quintic", {value}}, keys);
    if (!curve) return tl::unexpected(curve.error());
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{value});
    for (std::size_t key = 1; key <= shown; ++key)
      row.push_back(finite_or_dash(path_shape(curve->motion(knots[key])).curvature.norm()));
  }
  table.notes = {
      "The curvature is that of the path through the rotations: how its direction turns, by the angle "
      "travelled. It depends on the key's own α only.",
      "It falls as 1/|α| at first, and to |a × b|/|a + b|² in the end: the paper's sentence is true at the key."};
  return table;
}

Picture figure2(const Figure2& figure, const Keyframes& keys) {
  Picture picture("000-figure2", 860, 430);
  const report::View view = report::facing(axis_path(keys.orientations(), Eigen::Vector3d::UnitX()));
  std::vector<Served> left = figure.positive;
  left.push_back(figure.zero);
  double x = 215.0;
  for (const auto& curves : {left, figure.negative}) {
    const std::vector<report::Series> legend = names_of(curves);
    report::draw_legend(picture.drawing, {x - 195.0, 18.0}, std::span(legend).first(3));
    report::draw_legend(picture.drawing, {x - 195.0, 38.0}, std::span(legend).subspan(3));
    picture.add(view, {x, 240.0}, 175.0, sphere_of(curves, keys, Eigen::Vector3d::UnitX()));
    x += 430.0;
  }
  return picture;
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

/// Figure 3: the keys, then 17 bodies on a straight line per curve, the keys green and the new ones red.
Picture frames(const std::vector<Served>& curves, const Keyframes& keys) {
  constexpr FrameColors colors{.key = color::green, .between = color::red};
  std::vector<FrameRow> rows{key_frames("(a) keyframes", keys, colors)};
  for (const auto& [recipe, curve] : curves)
    rows.push_back(
        frames_of(lettered(rows.size(), recipe.label), curve, even_times(curve.domain(), 17), keys.times(), colors));
  Picture picture("000-figure3", 860, 20.0 + frame_row_height * static_cast<double>(rows.size()));
  picture.add_frames(11.0, std::move(rows));
  return picture;
}

using Figure = std::function<double(const Motion&)>;

report::Chart chart_of(const std::string& title, std::span<const Served> curves, const Figure& figure,
                       std::span<const double> knots) {
  report::Chart chart{.title = title, .series = {}, .marks = marks_at(knots)};
  for (const Served& served : curves) chart.series.push_back(over_time(served, figure));
  return chart;
}

/// Over time: the four schemes of (b), (c), (d) and (f), then the tensions of (e) to (j).
Picture rates(const std::vector<Served>& curves, std::span<const double> knots) {
  const std::vector<Served> schemes{curves[0], curves[1], curves[2], curves[4]};
  const auto tensions = std::span(curves).subspan(3);
  Picture picture("000-figure3-rates", 860, 740);
  double top = 58.0;
  for (const report::Chart& chart :
       {chart_of("angular velocity |ω| [rad/s] of the schemes", schemes, speed, knots),
        chart_of("angular acceleration |α| [rad/s²]", schemes, acceleration, knots),
        chart_of("angular velocity |ω| [rad/s] for six tension vectors", tensions, speed, knots)}) {
    report::draw_legend(picture.drawing, {50.0, top - 34.0}, chart.series);
    picture.add({50.0, top, 780.0, 160.0}, chart);
    top += 250.0;
  }
  return picture;
}

}  // namespace

Expected<Findings> experiment::one_tension() {
  return five_keys_at(even).and_then([](const Keyframes& keys) { return one_tension_of({keys, five_keys_note}); });
}

Expected<Findings> experiment::one_tension_of(const KeysInstead& keys) {
  return curves_of_figure2(keys.keys).and_then([&](const Figure2& figure) {
    return flatness_table(keys.keys).map([&](report::Table flatness) {
      std::vector<Served> all = figure.positive;
      all.insert(all.end(), figure.negative.begin() + 1, figure.negative.end());
      all.push_back(figure.zero);
      return Findings{{one_tension_table(all, keys), std::move(flatness)},
                      {figure2(figure, keys.keys)},
                      motions_of(all, keys.keys)};
    });
  });
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
