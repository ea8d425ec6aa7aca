// SPDX-License-Identifier: Apache-2.0
// The 6th degree: figures 1 to 6.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include <orispline/math/degrees.hpp>
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

report::Series legend_of(const Served& served) { return {short_label(served.recipe), {}, {}, served.recipe.stroke}; }

/// Figure 2 looks at the wing tip's path from outside, its middle in front.
class WingView {
 public:
  explicit WingView(const Flight& flight)
      : tips_(axis_path(flight.orientations, right_wing)), view_(report::facing(tips_)) {}

  [[nodiscard]] std::span<const Eigen::Vector3d> truth() const { return tips_; }

  /// A path as it is seen: degrees of the sphere's middle to the right and up.
  [[nodiscard]] report::Series seen(std::span<const Eigen::Vector3d> path, std::string label,
                                    const report::Stroke& stroke) const {
    report::Series series{std::move(label), {}, {}, stroke};
    for (const Eigen::Vector3d& tip : path) {
      const report::Point at = view_.at(tip, {0.0, 0.0}, degrees);
      series.x.push_back(at.x);
      series.y.push_back(-at.y);
    }
    return series;
  }

  /// How far a path is off the truth over time [degrees]: to the left of it, or ahead on it.
  [[nodiscard]] report::Series off(const Flight& flight, const Served& served, bool ahead) const {
    report::Series series = legend_of(served);
    const auto path = axis_path(served.curve, flight.times, right_wing);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, path.size() - 1);
      const Eigen::Vector3d along = (tips_[after] - tips_[before]).normalized();
      series.x.push_back(flight.times[i]);
      series.y.push_back(degrees * (path[i] - tips_[i]).dot(ahead ? along : tips_[i].cross(along)));
    }
    return series;
  }

 private:
  std::vector<Eigen::Vector3d> tips_;
  report::View view_;
};

/// The largest box of the paths' own shape in the room that there is.
report::Box fitting(const report::Box& room, const report::Range& x, const report::Range& y) {
  const double scale = std::min(room.width / x.extent(), room.height / y.extent());
  return {room.left, room.top, scale * x.extent(), scale * y.extent()};
}

/// The paths as large as there is room, with the keys as dots.
void add_large(Picture& picture, const report::Box& room, const WingView& view, const Flight& flight,
               const std::vector<Served>& curves) {
  report::Chart chart{.title = "path of the right wing tip as seen from outside [degrees]",
                      .series = {view.seen(view.truth(), "truth", truth_stroke)}};
  for (const auto& [recipe, curve] : curves)
    chart.series.push_back(view.seen(axis_path(curve, flight.times, right_wing), short_label(recipe), recipe.stroke));
  std::vector<double> xs, ys;
  for (const report::Series& series : chart.series) {
    xs.insert(xs.end(), series.x.begin(), series.x.end());
    ys.insert(ys.end(), series.y.begin(), series.y.end());
  }
  const report::Range wide = report::range_of(xs), y = report::with_margin(report::range_of(ys)),
                      x = wide.extent() > 0.0 ? wide : report::with_margin(wide);  // as the chart has it
  const report::Box box = fitting(room, x, y);
  chart.y = y;
  const report::Series keys = view.seen(axis_path(flight.keys.orientations(), right_wing), "keys", {});
  picture.add(box, chart);
  for (std::size_t i = 0; i < keys.x.size(); ++i) {
    const report::Point at{box.left + box.width * (keys.x[i] - x.low) / x.extent(),
                           box.top + box.height * (y.high - keys.y[i]) / y.extent()};
    picture.drawing.circle(at, 4.0, {color::ink}, {color::ink, 1.0});
    const report::Point out{at.x - box.left - 0.5 * box.width, at.y - box.top - 0.5 * box.height};
    const double share =
        14.0 / std::sqrt(out.x * out.x + out.y * out.y);  // away from the middle, where the paths are not
    if (keys.x.size() <= 12)
      picture.drawing.text({at.x + share * out.x, at.y + share * out.y + 4.0}, std::to_string(i + 1));
  }
}

Picture wing_paths(const Flight& flight, const std::vector<Served>& curves) {
  const WingView view(flight);
  Picture picture("003-figure2", 860, 600);
  std::vector<report::Series> legend{{"truth", {}, {}, {"#a8a8a8"}}};
  for (const Served& served : curves) legend.push_back(legend_of(served));
  report::draw_legend(picture.drawing, {20.0, 18.0}, legend);
  add_large(picture, {40.0, 60.0, 490.0, 500.0}, view, flight, curves);
  double top = 60.0;
  for (const auto& [title, ahead] : {std::pair{"off the true path, to its left [degrees]", false},
                                     std::pair{"ahead on the true path [degrees]", true}}) {
    report::Chart chart{.title = title, .series = {}, .marks = marks_at(flight.keys.times())};
    for (const Served& served : curves) chart.series.push_back(view.off(flight, served, ahead));
    picture.add({590.0, top, 250.0, 200.0}, std::move(chart));
    top += 270.0;
  }
  return picture;
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
      Panel{"figure 3: angle to the truth [rad]; the distance on the sphere of unit quaternions is half of it",
            [](const Motion& m, const Motion& truth) { return angular_distance(m.orientation, truth.orientation); }},
      Panel{"figure 4: speed of the right wing tip, at distance 1 [1/s]",
            [](const Motion& m, const Motion&) { return speed_of_point(right_wing)(m); }},
      Panel{"figure 5: angle of the rotation since the first key [rad]",
            [&](const Motion& m, const Motion&) { return angular_distance(start, m.orientation); }},
      Panel{"figure 6: angular speed |ω| [rad/s]", [](const Motion& m, const Motion&) { return speed(m); }}};
  Picture picture("003-figures3-6", 860, 860);
  double top = 58.0;
  for (const Panel& panel : panels) {
    const report::Chart drawn = chart(panel, flight, curves);
    if (top < 60.0) report::draw_legend(picture.drawing, {20.0, 18.0}, drawn.series);
    picture.add({50.0, top, 780.0, 140.0}, drawn);
    top += 205.0;
  }
  return picture;
}

/// Figure 1: 17 bodies at even times per curve, the keys red.
Picture orientations(const Flight& flight, const std::vector<Served>& curves) {
  constexpr FrameColors colors{.key = color::red, .between = color::gold};
  const auto keys = flight.keys.times();
  const auto times = even_times({keys.front(), keys.back()}, 17);
  const auto truth = [&](double t) {
    const auto next = std::ranges::lower_bound(flight.times, t - 1e-9);
    return next == flight.times.end() ? flight.orientations.back()
                                      : flight.orientations[static_cast<std::size_t>(next - flight.times.begin())];
  };
  std::vector<FrameRow> rows{key_frames("(a) keyframes", flight.keys, colors),
                             frames_of("(b) truth", truth, times, keys, colors)};
  for (const auto& [recipe, curve] : curves)
    rows.push_back(frames_of(lettered(rows.size(), recipe.label), curve, times, keys, colors));
  Picture picture("003-figure1", 860, 20.0 + frame_row_height * static_cast<double>(rows.size()));
  picture.add_frames(11.0, std::move(rows));
  return picture;
}

}  // namespace

std::vector<Picture> flight_pictures(const Flight& flight, const std::vector<Served>& drawn,
                                     const std::vector<Served>& framed) {
  return {orientations(flight, framed), wing_paths(flight, drawn), curves_over_time(flight, drawn)};
}

}  // namespace orispline::cli
