// SPDX-License-Identifier: Apache-2.0
// The 6th degree: table 1 and figures 2 to 6.
#include "papers/experiment.hpp"

#include <algorithm>
#include <cmath>

#include <orispline/analysis/distance.hpp>
#include <orispline/report/sphere.hpp>

#include "papers/example_data.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {
namespace {

using report::Notation;
namespace color = report::color;

/// A true motion, sampled, and keys taken from it.
struct Flight {
  std::vector<double> times;
  std::vector<Motion> truth;
  std::vector<Eigen::Quaterniond> orientations;
  Keyframes keys;
};

Expected<Flight> flight(std::span<const DataRow> truth, std::span<const DataRow> keys) {
  return Keyframes::make(key_data(keys)).map([&](Keyframes made) {
    Flight result{.times = {}, .truth = {}, .orientations = {}, .keys = std::move(made)};
    for (const DataRow& row : truth) {
      result.times.push_back(row.t);
      result.orientations.push_back(quaternion_wxyz(row.qw, row.qx, row.qy, row.qz));
      result.truth.push_back({.orientation = result.orientations.back(), .angular_velocity = {row.wx, row.wy, row.wz}});
    }
    return result;
  });
}

/// Five keys and the truth between them: the first turn of the bundled flight, from straight to straight flight.
Expected<Flight> first_turn() {
  constexpr std::size_t first = 260, step = 240, count = 5;  // samples of 0.01 s
  const auto rows = flight_truth_rows().subspan(first, (count - 1) * step + 1);
  std::vector<DataRow> keys;
  for (std::size_t i = 0; i < count; ++i) keys.push_back(rows[i * step]);
  return flight(rows, keys);
}

Expected<Flight> whole_flight() { return flight(flight_truth_rows(), flight_key_rows()); }

/// What the paper prints for a method.
struct Printed {
  Recipe recipe;
  std::string degree, mse, largest, seconds;
};

std::vector<Printed> methods() {
  const std::string none = "–";
  return {{{"Xing, quartic", "xing-quartic"}, "4", "0.012979", "0.256878", "0.540154"},
          {{"Xing, quintic", "xing-quintic", {}, {color::green, 1.8}}, "5", none, none, none},
          {{"Tan, α = 0.45", "quintic", {0.45}, {color::red, 1.8}}, "5", "0.011337", "0.188917", "0.738309"},
          {{"Tan, α = 0.6", "quintic", {0.6}}, "5", none, none, none},
          {{"6th degree, β = 0.025", "sextic", {0.025}, {color::purple, 1.8}}, "6", "0.001130", "0.079421", "0.715989"},
          {{"6th degree, β = 0.05", "sextic", {0.05}}, "6", none, none, none},
          {{"6th degree, β = 5/96", "sextic", {5.0 / 96.0}}, "6", none, none, none},
          {{"6th degree, β = 1/12", "sextic", {1.0 / 12.0}, {color::blue, 1.8}}, "6", none, none, none},
          {{"timed-c3", "timed-c3"}, "7", none, none, none},
          {{"auto", "auto"}, "5", none, none, none}};
}

/// Time to build a curve and to compute the orientation at every time of the truth [s].
double seconds_for(const Recipe& recipe, const Flight& flight) {
  std::vector<Eigen::Quaterniond> frames(flight.times.size());
  return seconds_of([&] {
    const auto curve = curve_of(recipe, flight.keys);
    std::ranges::transform(flight.times, frames.begin(), [&](double t) { return (*curve)(t); });
  });
}

Expected<report::Table> comparison(const std::string& title, const Flight& flight) {
  report::Table table{.title = title,
                      .columns = {{"curve"},
                                  {"method"},
                                  {"degree"},
                                  {"continuity"},
                                  {"MSE [rad²]", Notation::fixed, 6},
                                  {"maximum [rad]", Notation::fixed, 6},
                                  {"time [ms]", Notation::fixed, 3}}};
  for (const Printed& method : methods()) {
    const auto curve = curve_of(method.recipe, flight.keys);
    if (!curve) return tl::unexpected(curve.error());
    const DistanceStatistics distance = distance_to_reference(*curve, {flight.times, flight.orientations});
    table.rows.push_back({method.recipe.label, method.recipe.method, method.degree, measured_continuity(*curve),
                          distance.rms * distance.rms, distance.largest, 1e3 * seconds_for(method.recipe, flight)});
  }
  return table;
}

void add_printed_figures(report::Table& table) {
  table.columns.insert(table.columns.end(), {{"paper: MSE"}, {"maximum"}, {"time [s]"}});
  const auto printed = methods();
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].insert(table.rows[i].end(), {printed[i].mse, printed[i].largest, printed[i].seconds});
  table.notes = {
      "The error is the angle between curve and truth, at the 961 times of the truth. The degree is that of the "
      "blending.",
      "Continuity is in time and measured at the keys. Times are those of the curve and 961 orientations on this "
      "machine.",
      "Figures on the right are of the paper's own flight, which is not published; this is the bundled simulation.",
      "The paper says C3 for the quartic, which is C2, and gives the quartic's name to the quintic, its own curve at β "
      "= 5/96.",
      "In the paper a small β is the best. Here it is not: its curve slows down at every key, and the aircraft does "
      "not."};
}

std::vector<Recipe> drawn_methods() {
  std::vector<Recipe> recipes;
  for (Printed& method : methods())
    if (method.recipe.stroke.color != color::ink) recipes.push_back(std::move(method.recipe));
  return recipes;
}

const Eigen::Vector3d right_wing = -Eigen::Vector3d::UnitY();
constexpr report::Stroke truth_stroke{"#c8c8c8", 5.0};

/// Speed of the wing tip at unit distance [1/s].
double wing_speed(const Motion& m) { return m.angular_velocity.cross(right_wing).norm(); }

Picture wing_paths(const Flight& flight, const std::vector<Served>& curves) {
  report::Drawing drawing(860, 560);
  report::SpherePicture picture{{{axis_path(flight.orientations, right_wing), truth_stroke}}};
  std::vector<report::Series> legend{{"truth", {}, {}, {"#a8a8a8"}}};
  for (const Served& served : curves) {
    picture.paths.push_back({axis_path(served.curve, flight.times, right_wing), served.recipe.stroke});
    legend.push_back({served.recipe.label, {}, {}, served.recipe.stroke});
  }
  for (const Eigen::Vector3d& tip : axis_path(flight.keys.orientations(), right_wing))
    picture.dots.push_back({tip, std::to_string(picture.dots.size() + 1)});
  report::draw_legend(drawing, {20.0, 18.0}, legend);
  report::draw(drawing, report::facing(picture.paths[0].directions), {430.0, 295.0}, 250.0, picture);
  return {"003-figure2", std::move(drawing)};
}

/// Figures 3 to 6: what is drawn of a motion at a time of the truth.
struct Panel {
  std::string title;
  std::function<double(const Motion& motion, const Motion& truth)> figure;
};

report::Chart chart(const Panel& panel, const Flight& flight, const std::vector<Served>& curves) {
  report::Chart chart{.title = panel.title, .series = {}, .marks = marks_at(flight.keys.times())};
  const auto add = [&](const std::string& label, const report::Stroke& stroke, const auto& motion_at) {
    report::Series series{label, flight.times, {}, stroke};
    for (std::size_t i = 0; i < flight.times.size(); ++i)
      series.y.push_back(panel.figure(motion_at(i), flight.truth[i]));
    chart.series.push_back(std::move(series));
  };
  add("truth", truth_stroke, [&](std::size_t i) { return flight.truth[i]; });
  for (const Served& served : curves)
    add(served.recipe.label, served.recipe.stroke, [&](std::size_t i) { return served.curve.motion(flight.times[i]); });
  return chart;
}

Picture curves_over_time(const Flight& flight, const std::vector<Served>& curves) {
  const Eigen::Quaterniond start = flight.orientations.front();
  const std::array panels{
      Panel{"figure 3: distance to the truth [rad]",
            [](const Motion& m, const Motion& truth) { return angular_distance(m.orientation, truth.orientation); }},
      Panel{"figure 4: speed of the right wing tip, at distance 1 [1/s]",
            [](const Motion& m, const Motion&) { return wing_speed(m); }},
      Panel{"figure 5: angle of the rotation since the first key [rad]",
            [&](const Motion& m, const Motion&) { return angular_distance(start, m.orientation); }},
      Panel{"figure 6: angular speed |ω| [rad/s]", [](const Motion& m, const Motion&) { return speed(m); }}};
  report::Drawing drawing(860, 860);
  double top = 58.0;
  for (const Panel& panel : panels) {
    const report::Chart drawn = chart(panel, flight, curves);
    if (top < 60.0) report::draw_legend(drawing, {20.0, 18.0}, drawn.series);
    report::draw(drawing, {50.0, top, 780.0, 140.0}, drawn);
    top += 205.0;
  }
  return {"003-figures3-6", std::move(drawing)};
}

}  // namespace

Expected<Findings> experiment::flight_compared() {
  const auto five = first_turn(), all = whole_flight();
  if (!five) return tl::unexpected(five.error());
  if (!all) return tl::unexpected(all.error());
  auto even = comparison("Five keys, 2.4 s apart, of the bundled flight's first turn (2.6 to 12.2 s)", *five);
  auto uneven = comparison("The whole bundled flight: 38 keys at uneven times", *all);
  const auto curves = curves_through(five->keys, drawn_methods());
  if (!even) return tl::unexpected(even.error());
  if (!uneven) return tl::unexpected(uneven.error());
  if (!curves) return tl::unexpected(curves.error());
  add_printed_figures(*even);
  uneven->notes = {"This is not in the paper. On uneven knots its curves are continuous in shape (G), not in time."};
  return Findings{{std::move(*even), std::move(*uneven)},
                  {wing_paths(*five, *curves), curves_over_time(*five, *curves)}};
}

}  // namespace orispline::cli
