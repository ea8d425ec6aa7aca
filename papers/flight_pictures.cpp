// SPDX-License-Identifier: Apache-2.0
// The 6th degree: figures 1 to 6.
#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include <orispline/report/sphere.hpp>

#include "papers/flight.hpp"
#include "papers/frames.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

namespace color = report::color;

const Eigen::Vector3d right_wing = -Eigen::Vector3d::UnitY();
constexpr report::Stroke truth_stroke{"#c8c8c8", 5.0};

/// The label without the word that all curves of the paper's own share, for which a legend has no room.
std::string short_label(const Recipe& recipe) {
  constexpr std::string_view shared = "6th degree, ";
  return recipe.label.substr(recipe.label.starts_with(shared) ? shared.size() : 0);
}

/// Speed of the wing tip at unit distance [1/s].
double wing_speed(const Motion& m) { return m.angular_velocity.cross(right_wing).norm(); }

Picture wing_paths(const Flight& flight, const std::vector<Served>& curves) {
  report::Drawing drawing(860, 560);
  report::SpherePicture picture{{{axis_path(flight.orientations, right_wing), truth_stroke}}};
  std::vector<report::Series> legend{{"truth", {}, {}, {"#a8a8a8"}}};
  for (const Served& served : curves) {
    picture.paths.push_back({axis_path(served.curve, flight.times, right_wing), served.recipe.stroke});
    legend.push_back({short_label(served.recipe), {}, {}, served.recipe.stroke});
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
    add(short_label(served.recipe), served.recipe.stroke,
        [&](std::size_t i) { return served.curve.motion(flight.times[i]); });
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

/// Figure 1: 17 bodies at even times per curve, the keys red.
Picture orientations(const Flight& flight, const std::vector<Served>& curves) {
  constexpr FrameColors colors{.key = color::red, .between = color::gold};
  const auto keys = flight.keys.times();
  const auto times = even_times({keys.front(), keys.back()}, 17);
  const auto truth = [&](double t) {
    return flight.orientations[static_cast<std::size_t>(std::ranges::lower_bound(flight.times, t - 1e-9) -
                                                        flight.times.begin())];
  };
  std::vector<FrameRow> rows{frames_of("(a) keyframes", truth, keys, keys, colors),
                             frames_of("(b) truth", truth, times, keys, colors)};
  for (const auto& [recipe, curve] : curves) {
    const std::string letter(1, static_cast<char>('a' + rows.size()));
    rows.push_back(frames_of("(" + letter + ") " + recipe.label, curve, times, keys, colors));
  }
  report::Drawing drawing(860, 20.0 + frame_row_height * static_cast<double>(rows.size()));
  draw_frames(drawing, 11.0, rows);
  return {"003-figure1", std::move(drawing)};
}

}  // namespace

std::vector<Picture> flight_pictures(const Flight& flight, const std::vector<Served>& drawn,
                                     const std::vector<Served>& framed) {
  return {orientations(flight, framed), wing_paths(flight, drawn), curves_over_time(flight, drawn)};
}

}  // namespace orispline::cli
