// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_through.hpp>

#include <algorithm>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

Expected<BetaShape> shape_with_ghosts(std::size_t keys, const FamilySettings& settings) {
  const PerKey beta1 = settings.per_key("beta1"), beta2 = settings.per_key("beta2");
  const bool ghosts_have_their_own = std::max(beta1.values().size(), beta2.values().size()) == keys + 2;
  return beta_shape(BetaThrough::info.name, beta1.all_with_ghosts(keys), beta2.all_with_ghosts(keys))
      .map_error([&](Error error) {
        const std::size_t point = *error.where.key;
        return ghosts_have_their_own
                   ? at_value(std::move(error), point, keys + 2, keys)
                   : at_value(std::move(error), std::clamp<std::size_t>(point, 1, keys) - 1, keys, keys);
      });
}

/// The polygon of the curve whose joints are the keys.
template <CurvePoint P>
Expected<ControlPolygon<P>> polygon_through_joints(std::span<const P> keys, const BetaShape& shape) {
  return control_points_through(keys, BetaThrough::info.name, JointToKey<double>{&shape})
      .map([&](const std::vector<P>& solved) {
        const auto points = reflected(std::span<const P>(solved));
        std::vector<P> with_ghosts{points[-1]};
        with_ghosts.insert(with_ghosts.end(), solved.begin(), solved.end());
        with_ghosts.push_back(points[static_cast<std::ptrdiff_t>(keys.size())]);
        return beta_polygon(std::span<const P>(with_ghosts), shape);
      });
}

}  // namespace

Expected<BetaThrough::Construction> BetaThrough::construction(const Keyframes& keys, const FamilySettings& settings) {
  return shape_with_ghosts(keys.size(), settings).and_then([&](const BetaShape& shape) {
    return control_points_through(keys.orientations(), info.name, JointToKey<double>{&shape}).map([&](auto&& points) {
      return Construction{shape, std::move(points)};
    });
  });
}

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> BetaThrough::curve(const Keyframes& keys,
                                                                  const FamilySettings& settings) {
  return shape_with_ghosts(keys.size(), settings)
      .and_then([&](const BetaShape& shape) { return polygon_through_joints(keys.points<P>(), shape); })
      .map([&](ControlPolygon<P> polygon) {
        return CumulativeCurve<CubicBezierBasis, P>(key_knots(keys), {}, std::move(polygon));
      });
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> BetaThrough::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> BetaThrough::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
