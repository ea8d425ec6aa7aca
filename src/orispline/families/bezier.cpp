// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bezier.hpp>

#include <orispline/curve/increments.hpp>

namespace orispline::families {
namespace {

Knots joint_times(const Keyframes& keys) {
  std::vector<double> times;
  times.reserve(keys.size() / 3 + 1);
  for (std::size_t i = 0; i < keys.size(); i += 3) times.push_back(keys.times()[i]);
  return Knots(std::move(times));
}

}  // namespace

Expected<CubicBezierCurve> Bezier::curve(const Keyframes& keys, const FamilySettings&) {
  const auto q = keys.orientations();
  Knots knots = joint_times(keys);
  ControlPolygon polygon{.bases = {}, .increments = increments_between(q)};
  polygon.bases.reserve(knots.segments());
  for (std::size_t i = 0; i + 1 < q.size(); i += 3) polygon.bases.push_back(q[i]);
  return CubicBezierCurve(std::move(knots), CubicBezierBasis{}, std::move(polygon));
}

Expected<CubicBezierPath> Bezier::path(const Keyframes& keys, const FamilySettings&) {
  return CubicBezierPath(joint_times(keys), CubicBezierBasis{},
                         PathPolygon(keys.positions().begin(), keys.positions().end()));
}

}  // namespace orispline::families
