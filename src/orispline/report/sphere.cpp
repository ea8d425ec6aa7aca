// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/sphere.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/math/degrees.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/report/characters.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

Eigen::Vector3d middle_of(const Face& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : face.corners) sum += corner;
  return sum / static_cast<double>(face.corners.size());
}

bool is_seen(const Face& face, const View& view) {
  if (face.sides == Sides::both) return true;
  const auto& corner = face.corners;
  return view.depth((corner[1] - corner[0]).cross(corner[2] - corner[1])) > 0.0;
}

/// Not std::hypot, whose version of glibc 2.35 would keep programs from older systems.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

constexpr std::string_view globe = "#f7f9fb", graticule_color = "#dde3e8";
constexpr double pale = 0.45;

Eigen::Vector3d on_globe(int longitude, int latitude) {
  const double lambda = longitude * radians_per_degree, phi = latitude * radians_per_degree;
  const auto [sine, cosine] = elementary::sine_cosine(lambda);
  const auto [height, radius] = elementary::sine_cosine(phi);
  return {radius * cosine, radius * sine, height};
}

/// Parallels and meridians every 30 degrees.
std::vector<std::vector<Eigen::Vector3d>> graticule() {
  std::vector<std::vector<Eigen::Vector3d>> circles;
  for (int latitude = -60; latitude <= 60; latitude += 30) {
    circles.emplace_back();
    for (int longitude = -180; longitude <= 180; longitude += 4)
      circles.back().push_back(on_globe(longitude, latitude));
  }
  for (int longitude = 0; longitude < 360; longitude += 30) {
    circles.emplace_back();
    for (int latitude = -90; latitude <= 90; latitude += 4) circles.back().push_back(on_globe(longitude, latitude));
  }
  return circles;
}

/// A sphere in its picture.
struct Globe {
  View view;
  Point center;
  double radius;

  [[nodiscard]] Point at(const Eigen::Vector3d& direction) const { return view.at(direction, center, radius); }

  /// Draws the pieces of a path on one side: +1 towards the eye, -1 away from it.
  void draw_side(Drawing& drawing, std::span<const Eigen::Vector3d> path, double side, const Stroke& stroke) const {
    std::vector<Point> run;
    for (const Eigen::Vector3d& direction : path) {
      const bool shown = side * view.depth(direction) >= 0.0;
      run.push_back(shown ? at(direction) : Point{std::nan(""), std::nan("")});
    }
    drawing.line(run, stroke);
  }
};

/// Finds places for the labels of dots where no line runs and nothing else stands.
class LabelPlaces {
 public:
  LabelPlaces(const Globe& sphere, const SpherePicture& picture) : sphere_(sphere) {
    for (const SpherePath& path : picture.paths)
      for (const Eigen::Vector3d& direction : path.directions) taken_.push_back(sphere.at(direction));
    for (const SphereDot& dot : picture.dots) taken_.push_back(sphere.at(dot.direction));
  }

  /// The middle of the label: above the dot where there is room, else the roomiest of the places around it.
  Point beside(Point dot, std::string_view label) {
    const double half = 3.5 * static_cast<double>(characters(label)), aside = half + 9.0, high = 13.0;
    const std::array around{Point{0.0, -high},  Point{aside, -9.0}, Point{-aside, -9.0}, Point{aside, 0.0},
                            Point{-aside, 0.0}, Point{aside, 9.0},  Point{-aside, 9.0},  Point{0.0, high}};
    Point best{};
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& from_dot : around) {
      const Point place{dot.x + from_dot.x, dot.y + from_dot.y};
      const double room = std::min(enough, room_at(place, half));
      if (room > most) best = place, most = room;
    }
    for (const double x : {best.x - half, best.x, best.x + half}) taken_.push_back({x, best.y});
    return best;
  }

 private:
  static constexpr double enough = 9.0;  // [px], of half a letter's height and a little air

  /// From the line in the middle of a label to the nearest thing drawn.
  [[nodiscard]] double room_at(Point middle, double half) const {
    double room = std::abs(length(middle.x - sphere_.center.x, middle.y - sphere_.center.y) - sphere_.radius);
    for (const Point& p : taken_)
      room = std::min(room, length(std::max(0.0, std::abs(p.x - middle.x) - half), p.y - middle.y));
    return room;
  }

  const Globe& sphere_;
  std::vector<Point> taken_;
};

}  // namespace

std::span<const Face> aircraft() noexcept {
  static const std::vector<Face> faces{{{{1.0, 0.0, 0.0}, {-0.6, 0.8, 0.0}, {-0.4, 0.0, 0.0}}, 0.85},
                                       {{{1.0, 0.0, 0.0}, {-0.6, -0.8, 0.0}, {-0.4, 0.0, 0.0}}, 0.6},
                                       {{{0.1, 0.0, 0.0}, {-0.6, 0.0, 0.0}, {-0.6, 0.0, 0.55}}, 0.35}};
  return faces;
}

std::vector<SeenFace> seen_faces(const View& view, const Eigen::Quaterniond& orientation, std::span<const Face> body) {
  std::vector<Face> faces(body.begin(), body.end());
  for (Face& face : faces)
    for (Eigen::Vector3d& corner : face.corners) corner = to_world<double>(orientation, corner);
  std::erase_if(faces, [&view](const Face& face) { return !is_seen(face, view); });
  std::ranges::stable_sort(faces, {}, [&view](const Face& face) { return view.depth(middle_of(face)); });
  std::vector<SeenFace> seen;
  for (const Face& face : faces) {
    seen.push_back({{}, face.opacity});
    for (const Eigen::Vector3d& corner : face.corners) seen.back().corners.push_back(view.at(corner, {0.0, 0.0}, 1.0));
  }
  return seen;
}

void draw_body(Drawing& drawing, const View& view, Point center, double size, const Eigen::Quaterniond& orientation,
               std::string_view color, std::span<const Face> body) {
  for (SeenFace& face : seen_faces(view, orientation, body)) {
    for (Point& corner : face.corners) corner = {center.x + size * corner.x, center.y + size * corner.y};
    drawing.polygon(face.corners, {color, face.opacity}, {color, 0.8});
  }
}

void draw(Drawing& drawing, const View& view, Point center, double radius, const SpherePicture& picture) {
  const Globe sphere{view, center, radius};
  drawing.circle(center, radius, {globe}, {color::frame, 1.0});
  for (const SpherePath& path : picture.paths)
    sphere.draw_side(drawing, path.directions, -1.0, {path.stroke.color, pale * path.stroke.width, "3 3"});
  for (const auto& circle : graticule()) sphere.draw_side(drawing, circle, 1.0, {graticule_color, 1.0});
  for (const SpherePath& path : picture.paths) sphere.draw_side(drawing, path.directions, 1.0, path.stroke);
  LabelPlaces places(sphere, picture);
  for (const SphereDot& dot : picture.dots) {
    const Point p = sphere.at(dot.direction);
    const bool behind = view.depth(dot.direction) < 0.0;
    drawing.circle(p, 4.0, {behind ? color::white : dot.color}, {dot.color, 1.0});
    if (dot.label.empty()) continue;
    const Point label = places.beside(p, dot.label);
    drawing.text({label.x, label.y + 4.0}, dot.label, {Anchor::middle, dot.color});
  }
}

View facing(std::span<const Eigen::Vector3d> directions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& direction : directions) sum += direction;
  if (sum.norm() < 1e-3 * static_cast<double>(directions.size()) || directions.empty()) return View();
  return View(sum.normalized() + Eigen::Vector3d(0.0, 0.0, 0.2));
}

}}}  // namespace orispline::report
