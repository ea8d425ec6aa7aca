// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/report/view.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A path on the unit sphere, such as that of a body axis.
struct SpherePath {
  std::vector<Eigen::Vector3d> directions;
  Stroke stroke{.width = 2.0};
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
