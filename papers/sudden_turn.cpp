// SPDX-License-Identifier: Apache-2.0
// The 6th degree, section 4.2 and figure 7: the paper's uneven knots.
#include "papers/experiment.hpp"

#include <functional>
#include <utility>

#include <orispline/report/chart.hpp>

#include "papers/bodies.hpp"
#include "papers/example_data.hpp"
#include "papers/frames.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;
using Figure = std::function<double(const Motion&)>;

const std::vector<double> paper_knots{0.0, 0.5, 1.5, 2.25, 4.0};
constexpr auto paper_note =
    "The paper's keys are not published; these are the five of examples/data/five_keys.csv, at the paper's times.";

std::vector<Recipe> recipes_of_a_turn() {
  return {{"6th degree, β = 1/12", "sextic", {1.0 / 12.0}, {color::red, 1.8}},
          {"6th degree, β = 0.025", "sextic", {0.025}, {color::purple, 1.8}},
          {"timed-c3", "timed-c3", {}, {color::blue, 1.8}},
          {"timed-sextic", "timed-sextic", {}, {color::green, 1.8}}};
}

/// A dash where both are at rest.
report::Cell ratio_of(double before, double after) {
  if (before == 0.0 && after == 0.0) return "–";
  return before / after;
}

report::Table jumps(const std::vector<Served>& curves, std::span<const double> knots, const std::string& title,
                    const std::string& note) {
  report::Table table{.title = title,
                      .columns = {{"curve"},
                                  {"in time"},
                                  {"in shape"},
                                  {"knot [s]"},
                                  {"before", Notation::fixed, 6},
                                  {"after", Notation::fixed, 6},
                                  {"before/after", Notation::fixed, 6},
                                  {"steps after/before", Notation::fixed, 6},
                                  {"|jump of ω|", Notation::scientific, 1}}};
  for (const auto& [recipe, curve] : curves)
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
      const Motion before = curve.motion(knots[i], Side::left), after = curve.motion(knots[i], Side::right);
      table.rows.push_back({recipe.label, measured_continuity(curve), measured_shape(curve), knots[i], speed(before),
                            speed(after), ratio_of(speed(before), speed(after)),
                            (knots[i + 1] - knots[i]) / (knots[i] - knots[i - 1]),
                            (before.angular_velocity - after.angular_velocity).norm()});
    }
  table.notes = {
      "The curves of the paper are G3 here, and ω jumps at every knot by exactly the ratio of the steps beside it.",
      "The timed methods are C3 in time on any knots, and nothing jumps.", note};
  return table;
}

/// (c) and (d) of the figure, and the acceleration.
Picture speeds(const std::vector<Served>& curves, std::span<const double> knots) {
  Picture picture("003-figure7", 860, 640);
  double top = 58.0;
  for (const auto& [title, figure] : {std::pair{"(c) speed of the point at distance 1 along the handle [1/s]",
                                                Figure(speed_of_point(Eigen::Vector3d::UnitX()))},
                                      std::pair{"(d) angular speed |ω| [rad/s]", Figure(speed)},
                                      std::pair{"angular acceleration |α| [rad/s²]", Figure(acceleration)}}) {
    report::Chart chart{.title = title, .series = {}, .marks = marks_at(knots)};
    for (const Served& served : curves) chart.series.push_back(over_time(served, figure));
    if (top < 60.0) report::draw_legend(picture.drawing, {50.0, 18.0}, chart.series);
    picture.add({50.0, top, 780.0, 140.0}, std::move(chart));
    top += 198.0;
  }
  return picture;
}

/// (a) and (b) of the figure: the body at 17 even times, and the angle from the start, with the paper's own curve.
Picture body_and_angle(const std::vector<Served>& curves, const Keyframes& keys) {
  const auto paper = std::span(curves).first(2);
  std::vector<FrameRow> rows;
  report::Chart angle{
      .title = "(b) angle from the start [rad]: continuous", .series = {}, .marks = marks_at(keys.times())};
  for (const Served& served : paper) {
    const auto& [recipe, curve] = served;
    rows.push_back(frames_of(recipe.label, curve, even_times(curve.domain(), 17), keys.times(),
                             {.key = color::green, .between = recipe.stroke.color}));
    const Eigen::Quaterniond start = keys.orientations()[0];
    angle.series.push_back(
        over_time(served, [start](const Motion& m) { return angular_distance(start, m.orientation); }));
  }
  Picture picture("003-figure7-body", 860, 430);
  picture.drawing.text({50.0, 24.0}, "(a) the body at 17 even times; at a key it is green", {report::Anchor::start});
  picture.add_frames(36.0, std::move(rows), cup());
  report::draw_legend(picture.drawing, {50.0, 194.0}, angle.series);
  picture.add({50.0, 228.0, 780.0, 165.0}, angle);
  return picture;
}

Findings findings_of(const std::vector<Served>& curves, const Keyframes& keys, const std::string& title,
                     const std::string& note) {
  return {{jumps(curves, keys.times(), title, note)},
          {body_and_angle(curves, keys), speeds(curves, keys.times())},
          motions_of(curves, keys)};
}

}  // namespace

Expected<Findings> experiment::sudden_turn() {
  return five_keys_at(paper_knots).and_then([](const Keyframes& keys) {
    return curves_through(keys, recipes_of_a_turn()).map([&](const std::vector<Served>& curves) {
      return findings_of(curves, keys, "|ω| [rad/s] before and after each inner knot of 0, 0.5, 1.5, 2.25, 4 s",
                         paper_note);
    });
  });
}

Expected<Findings> experiment::turns_of(const KeysInstead& keys) {
  return curves_through(keys.keys, recipes_of_a_turn()).map([&](const std::vector<Served>& curves) {
    return findings_of(curves, keys.keys, "|ω| [rad/s] before and after each inner key", keys.note);
  });
}

}  // namespace orispline::cli
