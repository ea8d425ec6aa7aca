// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/math/eigen.hpp>

namespace orispline {

/// A sequence continued beyond its ends by reflection: element -k mirrors element k at the first one, and so at the
/// last.
template <class Point, class Mirror>
class Reflected {
 public:
  /// `mirror(at, point)` is the image of the point in the end element.
  Reflected(std::span<const Point> points, Mirror mirror) : points_(points), mirror_(mirror) {}

  [[nodiscard]] Point operator[](std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(points_.size()) - 1;
    if (i < 0) return mirror_(points_.front(), (*this)[-i]);
    if (i > last) return mirror_(points_.back(), (*this)[2 * last - i]);
    return points_[static_cast<std::size_t>(i)];
  }

 private:
  std::span<const Point> points_;
  Mirror mirror_;
};

/// Orientations continued by point reflection on the geodesic: at · q⁻¹ · at.
[[nodiscard]] inline auto reflected(std::span<const Eigen::Quaterniond> keys) {
  return Reflected(keys, [](const Eigen::Quaterniond& at, const Eigen::Quaterniond& q) -> Eigen::Quaterniond {
    return at * q.conjugate() * at;
  });
}

/// Positions continued by point reflection.
[[nodiscard]] inline auto reflected(std::span<const Eigen::Vector3d> points) {
  return Reflected(points,
                   [](const Eigen::Vector3d& at, const Eigen::Vector3d& p) -> Eigen::Vector3d { return 2.0 * at - p; });
}

/// Times continued by reflection.
[[nodiscard]] inline auto reflected(std::span<const double> times) {
  return Reflected(times, [](double at, double t) { return 2.0 * at - t; });
}

}  // namespace orispline
