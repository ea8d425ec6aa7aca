// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, figure 4.
#include "papers/experiment.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>

#include "papers/bodies.hpp"
#include "papers/example_data.hpp"
#include "papers/frames.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;

/// The paper's two curves in its colours, and the Hermite curve with the rates that the quintic has at even keys.
std::vector<Recipe> drawn_recipes() {
  return {{"quintic, α = 1", "quintic", {1.0}, {color::ink, 2.0}},
          {"cubic Hermite", "hermite-cumulative", {}, {color::gold, 2.0}},
          {"cubic Hermite, double rates", "hermite-cumulative", {2.0}, {color::sky, 1.5}}};
}

/// The largest jump of α at a key between the ends [rad/s²].
double jump_of_acceleration(const AnyCurve& curve, std::span<const double> knots) {
  double largest = 0.0;
  for (const double t : knots.subspan(1, knots.size() - 2))
    largest = std::max(
        largest,
        (curve.motion(t, Side::right).angular_acceleration - curve.motion(t, Side::left).angular_acceleration).norm());
  return largest;
}

report::Table table_of(const std::vector<Served>& curves, const KeysInstead& keys) {
  report::Table table{.title = "Figure 4: the quintic beside cubic Hermite curves",
                      .columns = {{"curve"},
                                  {"method"},
                                  {"continuity"},
                                  {"|ω| at key 2 [rad/s]", Notation::fixed, 4},
                                  {"largest |α| [rad/s²]", Notation::fixed, 3},
                                  {"largest jump of α at a key", Notation::scientific, 1},
                                  {"farthest from the quintic [degrees]", Notation::fixed, 3}}};
  const auto times = even_times(curves[0].curve.domain(), 401);
  for (const auto& [recipe, curve] : curves)
    table.rows.push_back({recipe.label, recipe.method, measured_continuity(curve),
                          speed(curve.motion(keys.keys.times()[1])), largest_over_time(curve, acceleration),
                          jump_of_acceleration(curve, keys.keys.times()),
                          degrees * largest_distance(curve, curves[0].curve, times)});
  table.notes = {
      "The Hermite curve has at a key the rate of the parabola through three keys: at even times half the quintic's "
      "with α = 1.",
      "The paper does not state its rates.",
      "The curves look alike and are not: at even times only the quintic has a continuous acceleration.", keys.note};
  return table;
}

Picture figure4(const std::vector<Served>& curves, const Keyframes& keys) {
  Picture picture("000-figure4", 860, 640);
  report::Chart chart{.title = "angular acceleration |α| [rad/s²]", .series = {}, .marks = marks_at(keys.times())};
  const auto paper = std::span(curves).first(2);
  for (const Served& served : paper) chart.series.push_back(over_time(served, acceleration));
  const report::SpherePicture sphere = sphere_of(paper, keys, Eigen::Vector3d::UnitX());
  picture.drawing.text({20.0, 24.0}, "(a) path of the body's x axis", {report::Anchor::start});
  picture.add(report::facing(sphere.paths[0].directions), {205.0, 212.0}, 165.0, sphere);
  report::draw_legend(picture.drawing, {440.0, 60.0}, chart.series);
  picture.add({440.0, 100.0, 395.0, 240.0}, chart);
  const std::vector<std::pair<std::string, const AnyCurve*>> motions{{"(c) cubic Hermite", &paper[1].curve},
                                                                     {"(d) quintic, α = 1", &paper[0].curve}};
  const FrameColors colors{.key = color::green, .between = color::red};
  std::vector<FrameRow> rows{key_frames("(b) keyframes", keys, colors)};
  for (const auto& [label, curve] : motions)
    rows.push_back(frames_of(label, *curve, even_times(curve->domain(), 17), keys.times(), colors));
  picture.add_frames(410.0, std::move(rows), cup());
  return picture;
}

}  // namespace

Expected<Findings> experiment::hermite_compared() {
  return five_keys_at({0.0, 1.0, 2.0, 3.0, 4.0}).and_then([](const Keyframes& keys) {
    return hermite_compared_on({keys, five_keys_note});
  });
}

Expected<Findings> experiment::hermite_compared_on(const KeysInstead& keys) {
  return curves_through(keys.keys, drawn_recipes()).map([&](const std::vector<Served>& curves) {
    return Findings{{table_of(curves, keys)}, {figure4(curves, keys.keys)}, motions_of(curves, keys.keys)};
  });
}

}  // namespace orispline::cli
