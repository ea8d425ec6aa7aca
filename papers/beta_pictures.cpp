// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, figures 1 to 4.
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/beta_polygon.hpp>
#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>

#include "papers/beta_example.hpp"
#include "papers/bodies.hpp"
#include "papers/frames.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Point;
namespace color = report::color;

report::SpherePath path_of(const CubicBezierCurve& curve, std::string_view stroke, std::string label) {
  const AnyCurve any(curve);
  return {axis_path(any, even_times(any.domain(), 401), Eigen::Vector3d::UnitX()), {stroke, 2.0}, std::move(label)};
}

/// The points of the polygon.
std::vector<report::SphereDot> dots(const BetaExample& example) {
  std::vector<report::SphereDot> dots;
  for (const Eigen::Vector3d& x : axis_path(example.keys.orientations(), Eigen::Vector3d::UnitX()))
    dots.push_back({x, formatted("P{}", dots.size())});
  return dots;
}

std::vector<report::SphereDot> joint_dots(const BetaExample& example, std::string_view painted) {
  std::vector<report::SphereDot> dots;
  for (const Eigen::Vector3d& x : axis_path(joints_of(example), Eigen::Vector3d::UnitX()))
    dots.push_back({x, "", painted});
  return dots;
}

/// The joints by the names of their control points: q10, q20 …, and the last one as that of the last segment.
std::vector<report::SphereDot> named_joints(const BetaExample& example, std::string_view painted) {
  auto dots = joint_dots(example, painted);
  for (std::size_t i = 0; i < dots.size(); ++i)
    dots[i].label = i + 1 < dots.size() ? formatted("q{}0", i + 1) : formatted("q{}3", i);
  return dots;
}

/// A point of figure 1, which lies in the plane of the picture.
struct NamedPoint {
  std::string_view name;
  Eigen::Vector3d at;
  Point label;  ///< from the point [px]
};

Point place_of(const Eigen::Vector3d& p) { return {110.0 + 190.0 * p.x(), 300.0 - 190.0 * p.y()}; }

void draw_line(report::Drawing& drawing, std::span<const Eigen::Vector3d> through, const report::Stroke& stroke) {
  std::vector<Point> places;
  for (const Eigen::Vector3d& p : through) places.push_back(place_of(p));
  drawing.line(places, stroke);
}

report::Series in_plane(std::string label, std::span<const Eigen::Vector3d> points) {
  report::Series series{.label = std::move(label), .x = {}, .y = {}};
  for (const Eigen::Vector3d& p : points) {
    series.x.push_back(p.x());
    series.y.push_back(p.y());
  }
  return series;
}

void draw_points(report::Drawing& drawing, std::span<const NamedPoint> points, std::string_view painted) {
  for (const NamedPoint& point : points) {
    const Point at = place_of(point.at);
    drawing.circle(at, 4.0, {painted}, {painted, 1.0});
    drawing.text({at.x + point.label.x, at.y + point.label.y + 4.0}, point.name, {report::Anchor::middle, painted});
  }
}

/// Figure 1: how the control points come about, in space, with the shape parameters of the examples.
Picture construction() {
  const std::array<Eigen::Vector3d, 4> p{{{0.0, 0.0, 0.0}, {0.75, 1.3, 0.0}, {2.55, 1.2, 0.0}, {3.3, 0.05, 0.0}}};
  const std::vector<double> both1(p.size(), beta1), both2(p.size(), beta2);
  const auto shape = beta_shape("beta", both1, both2);
  Picture picture("001-figure1", 860, 360);
  report::Drawing& drawing = picture.drawing;
  if (!shape) return picture;  // of these parameters there is always one
  const auto inner = [&](std::size_t arc, const std::vector<double>& share) {
    return on_geodesic(p[arc], p[arc + 1], share[arc]);
  };
  const Eigen::Vector3d q01 = inner(0, shape->inner1), q02 = inner(0, shape->inner2), q11 = inner(1, shape->inner1),
                        q12 = inner(1, shape->inner2), q21 = inner(2, shape->inner1), q22 = inner(2, shape->inner2),
                        q10 = shape->joint_at(1, p[0], p[1], p[2]), q20 = shape->joint_at(2, p[1], p[2], p[3]);
  const CumulativeCurve<CubicBezierBasis, Eigen::Vector3d> curve(Knots({0.0, 1.0}), {}, beta_polygon(p, *shape));
  std::vector<Eigen::Vector3d> path;
  for (const double t : even_times({0.0, 1.0}, 101)) path.push_back(curve.point(t, 0));
  draw_line(drawing, p, {color::grey, 1.2});
  for (const auto& [from, to] : {std::pair{q02, q11}, std::pair{q12, q21}})
    draw_line(drawing, std::array{from, to}, {color::blue, 1.2, "4 3"});
  draw_line(drawing, path, {color::red, 2.5});
  const std::array given{NamedPoint{"p₀", p[0], {-14, 4}}, NamedPoint{"p₁", p[1], {-6, -14}},
                         NamedPoint{"p₂", p[2], {8, -14}}, NamedPoint{"p₃", p[3], {14, 4}}};
  const std::array inside{NamedPoint{"q₀,₁", q01, {-22, -4}}, NamedPoint{"q₀,₂", q02, {-22, -4}},
                          NamedPoint{"q₁,₁", q11, {0, -15}},  NamedPoint{"q₁,₂", q12, {0, -15}},
                          NamedPoint{"q₂,₁", q21, {22, -4}},  NamedPoint{"q₂,₂", q22, {22, -4}}};
  const std::array joints{NamedPoint{"q₁,₀ = q₀,₃", q10, {30, 16}}, NamedPoint{"q₂,₀ = q₁,₃", q20, {-30, 16}}};
  draw_points(drawing, given, color::ink);
  draw_points(drawing, inside, color::blue);
  draw_points(drawing, joints, color::green);
  const std::string title = formatted("the segment s₁ of four points, β₁ = {:g} and β₂ = {:g} at each", beta1, beta2);
  drawing.text({430.0, 345.0}, title);
  picture.keep({.title = title, .series = {in_plane("segment", path), in_plane("points", p)}});
  return picture;
}

/// Figure 2, and the acceleration.
Picture path_picture(const BetaExample& example) {
  Picture picture("001-example1", 860, 400);
  report::SpherePicture sphere{{path_of(example.curve, color::blue, "example 1")}, named_joints(example, color::green)};
  for (report::SphereDot& dot : dots(example)) sphere.dots.push_back(std::move(dot));
  picture.add(report::facing(sphere.paths[0].directions), {215.0, 205.0}, 165.0, sphere);
  picture.drawing.text({215.0, 24.0}, "example 1: path of the body's x axis");
  report::Chart chart{.title = "angular acceleration |α| [rad/s²]: it jumps at the joint",
                      .series = {over_time(AnyCurve(example.curve), acceleration)},
                      .marks = marks_at(example.curve.knots().times())};
  chart.series[0].stroke = {color::blue, 2.0};
  picture.add({475.0, 90.0, 355.0, 220.0}, chart);
  return picture;
}

/// Figure 3: cubes on a straight line, at joints green.
Picture cubes(const BetaExample& example) {
  const AnyCurve curve(example.curve);
  Picture picture("001-figure3", 860, 20.0 + frame_row_height);
  picture.add_frames(11.0,
                     {frames_of("example 1", curve, even_times(curve.domain(), 17), curve.knots().times(),
                                {.key = color::green, .between = color::grey})},
                     cube());
  return picture;
}

}  // namespace

std::vector<Eigen::Quaterniond> joints_of(const BetaExample& example) {
  const AnyCurve curve(example.curve);
  std::vector<Eigen::Quaterniond> joints;
  for (const double t : curve.knots().times()) joints.push_back(curve(t));
  return joints;
}

std::vector<Picture> example1_pictures(const BetaExample& example) {
  return {construction(), path_picture(example), cubes(example)};
}

Picture effect_picture(const std::vector<Variant>& all) {
  Picture picture("001-example2", 860, 430);
  for (const std::size_t signs : {0U, 1U}) {
    report::SpherePicture sphere{{}, dots(all[0].examples[signs].example)};
    std::vector<report::Series> legend;
    for (const Variant& variant : all) {
      const BetaExample& example = variant.examples[signs].example;
      sphere.paths.push_back(path_of(example.curve, variant.color, formatted("β₁,₂ = {:g}", variant.beta2_of_point1)));
      for (report::SphereDot& dot : joint_dots(example, variant.color)) sphere.dots.push_back(std::move(dot));
      legend.push_back({formatted("β₁,₂ = {:g}", variant.beta2_of_point1), {}, {}, {variant.color}});
    }
    const double x = signs == 0 ? 215.0 : 645.0;
    picture.add(report::facing(sphere.paths[0].directions), {x, 250.0}, 165.0, sphere);
    picture.drawing.text({x, 60.0}, "signs " + all[0].examples[signs].signs + "; a joint is a dot");
    if (signs == 0) report::draw_legend(picture.drawing, {50.0, 20.0}, legend);
  }
  return picture;
}

}  // namespace orispline::cli
