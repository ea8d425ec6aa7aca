// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta.hpp>

#include <orispline/curve/beta_polygon.hpp>

namespace orispline::families {
namespace {

Expected<BetaShape> shape_of(std::size_t points, const FamilySettings& settings) {
  return beta_shape("beta", settings.per_key("beta1").all(points), settings.per_key("beta2").all(points));
}

Knots joint_times(const Keyframes& keys) { return Knots({keys.times().begin() + 1, keys.times().end() - 1}); }

}  // namespace

Expected<CubicBezierCurve> Beta::curve(const Keyframes& keys, const FamilySettings& settings) {
  return shape_of(keys.size(), settings).map([&](const BetaShape& shape) {
    return CubicBezierCurve(joint_times(keys), CubicBezierBasis{}, beta_polygon(keys.orientations(), shape));
  });
}

Expected<CubicBezierPath> Beta::path(const Keyframes& keys, const FamilySettings& settings) {
  return shape_of(keys.size(), settings).map([&](const BetaShape& shape) {
    return CubicBezierPath(joint_times(keys), CubicBezierBasis{}, beta_polygon(keys.positions(), shape));
  });
}

}  // namespace orispline::families
