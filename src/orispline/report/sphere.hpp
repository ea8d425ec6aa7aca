// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <orispline/math/eigen.hpp>
#include <orispline/report/svg.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// How the world is looked at from far away: z is up in the picture, as far as the eye allows.
class View {
 public:
  /// `eye` is the direction [any length but 0] from which the world is seen.
  explicit View(const Eigen::Vector3d& eye = {1.0, 0.12, 0.22}) : eye_(eye.normalized()) {
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ(), x = Eigen::Vector3d::UnitX();
    right_ = (std::abs(eye_.z()) < 0.999 ? z : x).cross(eye_).normalized();
    up_ = eye_.cross(right_);
  }

  /// Towards the eye; negative on the far side.
  [[nodiscard]] double depth(const Eigen::Vector3d& v) const { return v.dot(eye_); }
  [[nodiscard]] Point at(const Eigen::Vector3d& v, Point center, double scale) const {
    return {center.x + scale * v.dot(right_), center.y - scale * v.dot(up_)};
  }

 private:
  Eigen::Vector3d eye_, right_, up_;
};

/// From where a face of a body is seen.
enum class Sides { both, outside };

/// A flat piece of a body.
struct Face {
  std::vector<Eigen::Vector3d> corners;  ///< in the body's frame; seen from outside they go round counterclockwise
  double opacity = 1.0;
  Sides sides = Sides::both;
};

/// A small aircraft: its nose along the body's x axis, the left wing along y, the fin along z.
[[nodiscard]] ORISPLINE_EXPORT std::span<const Face> aircraft() noexcept;

/// A face of a body as it is seen, one unit of the body long, its center at the origin.
struct SeenFace {
  std::vector<Point> corners;
  double opacity;
};

/// The faces of a body that are seen, the nearer ones later.
[[nodiscard]] ORISPLINE_EXPORT std::vector<SeenFace> seen_faces(const View& view, const Eigen::Quaterniond& orientation,
                                                                std::span<const Face> body = aircraft());

/// Draws a body, its nearer faces on top; one unit of the body is `size` [px].
ORISPLINE_EXPORT void draw_body(Drawing& drawing, const View& view, Point center, double size,
                                const Eigen::Quaterniond& orientation, std::string_view color,
                                std::span<const Face> body = aircraft());

/// A path on the unit sphere, such as that of a body axis.
struct SpherePath {
  std::vector<Eigen::Vector3d> directions;
  Stroke stroke{.width = 2.0};
  std::string label{};  ///< is not drawn
};

/// A point on the unit sphere.
struct SphereDot {
  Eigen::Vector3d direction;
  std::string label{};
  std::string_view color = color::ink;
};

struct SpherePicture {
  std::vector<SpherePath> paths;
  std::vector<SphereDot> dots{};
};

/// Draws the unit sphere with what is on it; what lies on the far side shines through, pale.
ORISPLINE_EXPORT void draw(Drawing& drawing, const View& view, Point center, double radius,
                           const SpherePicture& picture);

/// The view that has the middle of the directions in front, a little from above.
[[nodiscard]] ORISPLINE_EXPORT View facing(std::span<const Eigen::Vector3d> directions);

}}}  // namespace orispline::report
