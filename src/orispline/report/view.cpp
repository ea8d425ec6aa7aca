// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/view.hpp>

#include <algorithm>

#include <orispline/math/so3.hpp>

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

}}}  // namespace orispline::report
