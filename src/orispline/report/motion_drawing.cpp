// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/motion_drawing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double width = 1180.0, chart_height = 130.0, chart_pitch = 185.0, charts_top = 85.0;
constexpr double charts_left = 70.0, charts_width = 660.0;
constexpr Point legend_at{charts_left, 50.0};
constexpr double legend_width = width - charts_left;
constexpr Point sphere_center{970.0, 400.0};  // below a legend of one line
constexpr double sphere_radius = 175.0;
constexpr std::array<std::string_view, most_drawn_methods> colors{color::blue,   color::red,  color::green,
                                                                  color::purple, color::gold, color::sky};

using Values = std::vector<double>;

Values angles_from_start(const PageSamples& samples) {
  Values angles;
  for (const Eigen::Quaterniond& q : samples.path.orientations)
    angles.push_back(angular_distance(samples.path.orientations.front(), q) / radians_per_degree);
  return angles;
}

Values norms(const std::vector<Eigen::Vector3d>& vectors) {
  Values values;
  for (const Eigen::Vector3d& v : vectors) values.push_back(v.norm());
  return values;
}

constexpr std::array<DrawnQuantity, 4> quantities{{
    {"angle", "angle from the start [deg]", angles_from_start},
    {"rate", "angular velocity |ω| [rad/s]", [](const PageSamples& s) { return norms(s.angular_velocities); }},
    {"acceleration", "angular acceleration |α| [rad/s²]",
     [](const PageSamples& s) { return norms(s.angular_accelerations); }},
    {"jerk", "angular jerk [rad/s³]", [](const PageSamples& s) { return norms(s.angular_jerks); }},
}};

std::vector<Mark> marks_at(const std::vector<double>& times) {
  std::vector<Mark> marks;
  if (times.size() <= most_marked_keys)
    for (const double t : times) marks.push_back({t});
  return marks;
}

Chart chart_of(const DrawnQuantity& quantity, const MotionPicture& picture) {
  Chart chart{.title = std::string(quantity.title), .series = {}, .marks = marks_at(picture.keys.path.times)};
  chart.x_unit = " s";
  for (std::size_t i = picture.methods.size(); i-- > 0;)  // the first one on top
    chart.series.push_back({picture.methods[i].name, picture.methods[i].samples.path.times,
                            quantity.values(picture.methods[i].samples), Stroke{colors[i], i == 0 ? 2.0 : 1.4}});
  return chart;
}

std::vector<Eigen::Vector3d> axis_path(const PagePath& path, const Eigen::Vector3d& axis) {
  std::vector<Eigen::Vector3d> directions;
  for (const Eigen::Quaterniond& q : path.orientations) directions.push_back(to_world<double>(q, axis));
  return directions;
}

/// A name in lines for which there is room, broken behind commas.
std::string broken(std::string_view name) {
  std::string lines, line;
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t comma = rest.find(',');
    const std::string_view piece = rest.substr(0, comma == rest.npos ? comma : comma + 1);
    rest.remove_prefix(piece.size());
    if (!line.empty() && legend_pitch(line + std::string(piece)) > legend_width)
      lines += std::exchange(line, {}) + "\n";
    line += piece;
  }
  return lines + line;
}

/// The names of the methods: in one row where there is room, else below each other.
struct Legend {
  std::vector<Series> names{};
  bool is_row = true;

  explicit Legend(const MotionPicture& picture) {
    double row = 0.0;
    for (std::size_t i = 0; i < picture.methods.size(); ++i) {
      names.push_back({picture.methods[i].name, {}, {}, Stroke{colors[i]}});
      row += legend_pitch(names.back().label);
    }
    is_row = row <= legend_width;
    if (!is_row)
      for (Series& name : names) name.label = broken(name.label);
  }

  static double height(const Series& name) {
    return legend_line * static_cast<double>(1 + std::ranges::count(name.label, '\n'));
  }
  /// More than that of one line.
  [[nodiscard]] double further_height() const {
    double sum = 0.0;
    if (!is_row)
      for (const Series& name : names) sum += height(name);
    return std::max(0.0, sum - legend_line);
  }

  void draw(Drawing& drawing) const {
    if (is_row) return draw_legend(drawing, legend_at, names);
    Point at = legend_at;
    for (const Series& name : names) {
      draw_legend(drawing, at, std::span(&name, 1));
      at.y += height(name);
    }
  }
};

void draw_sphere(Drawing& drawing, const MotionPicture& picture, Point center) {
  SpherePicture sphere;
  for (std::size_t i = picture.methods.size(); i-- > 0;)
    sphere.paths.push_back({axis_path(picture.methods[i].samples.path, picture.body_axis), {colors[i], 2.0}});
  const auto keys = axis_path(picture.keys.path, picture.body_axis);
  if (keys.size() <= most_marked_keys)
    for (const Eigen::Vector3d& key : keys) sphere.dots.push_back({key});
  drawing.text({center.x, center.y - sphere_radius - 25.0}, "body axis " + picture.axis_name + " on the unit sphere");
  draw(drawing, facing(keys), center, sphere_radius, sphere);
}

/// How large the bodies are of which so many stand in a row [px].
double ghost_size(std::size_t count) { return std::min(24.0, 0.55 * charts_width / static_cast<double>(count)); }

double ghost_row(std::size_t count) { return 2.2 * ghost_size(count) + 6.0; }

/// The orientation of a densely sampled motion at a time [s] of its path.
const Eigen::Quaterniond& orientation_at(const PagePath& path, double time) {
  const auto after = std::ranges::lower_bound(path.times, time);
  const auto i = std::min(after - path.times.begin(), std::ssize(path.times) - 1);
  const bool earlier = i > 0 && time - path.times[static_cast<std::size_t>(i - 1)] < *(path.times.begin() + i) - time;
  return path.orientations[static_cast<std::size_t>(earlier ? i - 1 : i)];
}

void draw_ghosts(Drawing& drawing, const MotionPicture& picture, double top) {
  const View view = view_of_ghosts();
  drawing.text({charts_left, top}, formatted("the body at {} even times", picture.ghosts), {Anchor::start});
  double y = top + 10.0 + 0.5 * ghost_row(picture.ghosts);
  for (std::size_t i = 0; i < picture.methods.size(); ++i) {
    const PagePath& path = picture.methods[i].samples.path;
    for (std::size_t k = 0; k < picture.ghosts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(picture.ghosts - 1);
      draw_body(drawing, view, {charts_left + share * charts_width, y}, ghost_size(picture.ghosts),
                orientation_at(path, std::lerp(path.times.front(), path.times.back(), share)), colors[i]);
    }
    y += ghost_row(picture.ghosts);
  }
}

double ghosts_height(const MotionPicture& picture) {
  return picture.ghosts == 0 ? 0.0 : 20.0 + static_cast<double>(picture.methods.size()) * ghost_row(picture.ghosts);
}

}  // namespace

std::span<const DrawnQuantity> drawn_quantities() noexcept { return quantities; }

Drawing motion_drawing(const MotionPicture& picture) {
  const Legend legend(picture);
  const double lower = legend.further_height();
  const double charts_bottom = charts_top + lower + chart_pitch * static_cast<double>(quantities.size());
  Drawing drawing(width, charts_bottom + ghosts_height(picture));
  drawing.text({charts_left, 28.0}, picture.title, {Anchor::start, color::ink, 16.0});
  legend.draw(drawing);
  double top = charts_top + lower;
  for (const DrawnQuantity& quantity : quantities) {
    draw(drawing, {charts_left, top, charts_width, chart_height}, chart_of(quantity, picture));
    top += chart_pitch;
  }
  draw_sphere(drawing, picture, {sphere_center.x, sphere_center.y + lower});
  if (picture.ghosts > 1) draw_ghosts(drawing, picture, charts_bottom);
  return drawing;
}

}}}  // namespace orispline::report
