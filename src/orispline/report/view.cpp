// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/view.hpp>

#include <algorithm>
#include <array>

#include <orispline/math/so3.hpp>

namespace orispline::inline ORISPLINE_ABI::report {
namespace {

struct Face {
  std::array<Eigen::Vector3d, 3> corners;
  double opacity;
};

const std::array<Face, 3> aircraft{Face{{{{1.0, 0.0, 0.0}, {-0.6, 0.8, 0.0}, {-0.4, 0.0, 0.0}}}, 0.85},
                                   Face{{{{1.0, 0.0, 0.0}, {-0.6, -0.8, 0.0}, {-0.4, 0.0, 0.0}}}, 0.6},
                                   Face{{{{0.1, 0.0, 0.0}, {-0.6, 0.0, 0.0}, {-0.6, 0.0, 0.55}}}, 0.35}};

}  // namespace

void draw_body(Drawing& drawing, const View& view, Point center, double size, const Eigen::Quaterniond& orientation,
               std::string_view color) {
  std::array<Face, 3> faces = aircraft;
  for (Face& face : faces)
    for (Eigen::Vector3d& corner : face.corners) corner = to_world<double>(orientation, corner);
  const auto depth = [&view](const Face& face) {
    return view.depth(face.corners[0] + face.corners[1] + face.corners[2]);
  };
  std::ranges::sort(faces, {}, depth);
  for (const Face& face : faces) {
    std::array<Point, 3> corners{};
    std::ranges::transform(face.corners, corners.begin(),
                           [&](const Eigen::Vector3d& corner) { return view.at(corner, center, size); });
    drawing.polygon(corners, {color, face.opacity}, {color, 0.8});
  }
}

}  // namespace orispline::inline ORISPLINE_ABI::report
