// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bezier.hpp>

#include <fmt/format.h>

#include <orispline/curve/increments.hpp>

namespace orispline::families {
namespace {

Expected<Knots> joint_times(const Keyframes& keys) {
  if (keys.size() % 3 != 1)
    return failure(ErrorCode::bad_data, fmt::format("bezier needs 3k+1 keys (4, 7, 10, ...), found {}", keys.size()));
  std::vector<double> times;
  times.reserve(keys.size() / 3 + 1);
  for (std::size_t i = 0; i < keys.size(); i += 3) times.push_back(keys.times()[i]);
  return Knots(std::move(times));
}

}  // namespace

Expected<CubicBezierCurve> Bezier::curve(const Keyframes& keys, const FamilySettings&) {
  return joint_times(keys).map([&](Knots knots) {
    const auto q = keys.orientations();
    ControlPolygon polygon{.bases = {}, .increments = increments_between(q)};
    polygon.bases.reserve(knots.segments());
    for (std::size_t i = 0; i + 1 < q.size(); i += 3) polygon.bases.push_back(q[i]);
    return CubicBezierCurve(std::move(knots), CubicBezierBasis{}, std::move(polygon));
  });
}

Expected<CubicBezierPath> Bezier::path(const Keyframes& keys, const FamilySettings&) {
  return joint_times(keys).map([&](Knots knots) {
    return CubicBezierPath(std::move(knots), CubicBezierBasis{},
                           PathPolygon(keys.positions().begin(), keys.positions().end()));
  });
}

}  // namespace orispline::families
