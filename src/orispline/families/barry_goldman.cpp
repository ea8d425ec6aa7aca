// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/barry_goldman.hpp>

#include <orispline/curve/reflected.hpp>

namespace orispline::families {
namespace {

template <class Point>
Pyramid<Point> pyramid(std::span<const Point> points, std::span<const double> times) {
  const auto p = reflected(points);
  const auto t = reflected(times);
  std::vector<typename Pyramid<Point>::Segment> segments;
  for (std::ptrdiff_t i = 0; i + 1 < std::ssize(points); ++i)
    segments.push_back({.points = {p[i - 1], p[i], p[i + 1], p[i + 2]},
                        .times = {t[i - 1], t[i], t[i + 1], t[i + 2]},
                        .steps = {displacement<double>(p[i - 1], p[i]), displacement<double>(p[i], p[i + 1]),
                                  displacement<double>(p[i + 1], p[i + 2])}});
  return {Knots({times.begin(), times.end()}), std::move(segments)};
}

}  // namespace

Expected<Pyramid<Eigen::Quaterniond>> BarryGoldman::curve(const Keyframes& keys, const FamilySettings&) {
  return pyramid(keys.orientations(), keys.times());
}

Expected<Pyramid<Eigen::Vector3d>> BarryGoldman::path(const Keyframes& keys, const FamilySettings&) {
  return pyramid(keys.positions(), keys.times());
}

}  // namespace orispline::families
