// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/curve/cumulative_curve.hpp>

// The B-spline family written down once more as docs/families/bspline.md defines it: every knot and every control point
// in a list, ghosts by repeated reflection. Its own types, for tests that need more derivatives than a Motion has.

namespace orispline::testing_support {

/// Key times continued with the end spacing, as many beyond either end as a degree can need.
inline constexpr std::size_t times_beyond = 6;
[[nodiscard]] inline std::vector<double> continued_times(std::span<const double> t) {
  std::vector<double> all;
  for (std::size_t k = times_beyond; k > 0; --k) all.push_back(t[0] - static_cast<double>(k) * (t[1] - t[0]));
  all.insert(all.end(), t.begin(), t.end());
  const double last_step = t[t.size() - 1] - t[t.size() - 2];
  for (std::size_t k = 1; k <= times_beyond; ++k) all.push_back(t.back() + static_cast<double>(k) * last_step);
  return all;
}

/// Knots of the basis functions: `Degree` of them before the end of the first span.
template <std::size_t Degree>
[[nodiscard]] std::vector<double> bspline_knots(std::span<const double> t) {
  const std::vector<double> all = continued_times(t);
  std::vector<double> knots;
  if constexpr (Degree % 2 == 1) {
    knots.assign(all.begin() + times_beyond - (Degree - 1), all.end());
  } else {
    for (std::size_t i = times_beyond - Degree; i + 1 < all.size(); ++i) knots.push_back(0.5 * (all[i] + all[i + 1]));
  }
  return knots;
}

template <std::size_t Degree>
[[nodiscard]] Knots bspline_spans(std::span<const double> t) {
  std::vector<double> spans{t.front()};
  if constexpr (Degree % 2 == 0)
    for (std::size_t i = 0; i + 1 < t.size(); ++i) spans.push_back(0.5 * (t[i] + t[i + 1]));
  else spans.insert(spans.end(), t.begin() + 1, t.end() - 1);
  spans.push_back(t.back());
  return Knots(std::move(spans));
}

/// Control points with `Degree / 2` ghosts on either side, each mirrored at the end key from the polygon so far: for
/// few keys a ghost is the image of a ghost.
template <std::size_t Degree, class Point>
[[nodiscard]] std::vector<Point> ghosted(std::span<const Point> keys) {
  const auto mirror = [](const auto& at, const auto& p) -> Point {
    if constexpr (std::same_as<Point, Eigen::Quaterniond>) return at * p.conjugate() * at;
    else return 2.0 * at - p;
  };
  std::vector<Point> points(keys.begin(), keys.end());
  for (std::size_t ghost = 1; ghost <= Degree / 2; ++ghost) {
    const std::size_t first = ghost - 1, last = points.size() - ghost;
    const Point before = mirror(points[first], points[first + ghost]);
    const Point after = mirror(points[last], points[last - ghost]);
    points.insert(points.begin(), before);
    points.push_back(after);
  }
  return points;
}

template <std::size_t Degree, CurvePoint P = Eigen::Quaterniond>
[[nodiscard]] auto bspline_curve(const Keyframes& keys) {
  const std::vector<P> points = ghosted<Degree>(keys.points<P>());
  ControlPolygon<P> polygon{.bases = points, .increments = {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    polygon.increments.push_back(displacement<double>(points[i], points[i + 1]));
  using Basis = BSplineBasis<Degree>;
  return CumulativeCurve<Basis, P>(bspline_spans<Degree>(keys.times()), Basis{bspline_knots<Degree>(keys.times())},
                                   std::move(polygon));
}

}  // namespace orispline::testing_support
