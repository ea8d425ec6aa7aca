// SPDX-License-Identifier: Apache-2.0
// The bodies of the papers' pictures.
#include "papers/bodies.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace orispline::cli {

namespace {

using Eigen::Vector3d;
using report::Face;
using report::Sides;

constexpr double pi = std::numbers::pi;

/// On a circle about the z axis.
Vector3d around(double angle, double radius, double height) {
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

/// On the handle's bow, which stands in the plane of x and z.
Vector3d on_handle(double angle, double side) {
  return {0.45 + 0.42 * std::sin(angle), side, 0.08 + 0.34 * std::cos(angle)};
}

}  // namespace

std::vector<Face> cube() {
  constexpr double half = 0.6;
  constexpr std::array shades{0.9, 0.55, 0.25};
  std::vector<Face> faces;
  for (const int axis : {0, 1, 2})
    for (const double side : {-1.0, 1.0}) {
      const Vector3d out = side * Vector3d::Unit(axis), u = Vector3d::Unit((axis + 1) % 3), v = out.cross(u);
      faces.push_back({{half * (out + u + v), half * (out - u + v), half * (out - u - v), half * (out + u - v)},
                       shades[static_cast<std::size_t>(axis)],
                       Sides::outside});
    }
  return faces;
}

std::vector<Face> cup() {
  constexpr int walls = 12, bows = 5;
  constexpr double bottom = -0.6, top = 0.6, narrow = 0.38, wide = 0.55, half_width = 0.09;
  std::vector<Face> faces{{{}, 0.5}};
  for (int k = 0; k < walls; ++k) {
    const double from = 2.0 * pi * k / walls, to = 2.0 * pi * (k + 1) / walls;
    faces[0].corners.push_back(around(from, narrow, bottom));
    faces.push_back(
        {{around(from, narrow, bottom), around(to, narrow, bottom), around(to, wide, top), around(from, wide, top)},
         0.4 + 0.3 * std::sin(0.5 * (from + to))});
  }
  for (int k = 0; k < bows; ++k) {
    const double from = pi * k / bows, to = pi * (k + 1) / bows;
    faces.push_back({{on_handle(from, half_width), on_handle(to, half_width), on_handle(to, -half_width),
                      on_handle(from, -half_width)},
                     0.9});
  }
  return faces;
}

}  // namespace orispline::cli
