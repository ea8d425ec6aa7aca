// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_through.hpp>

#include <algorithm>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/reflected.hpp>
#include <orispline/families/betas.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// With the points beyond the ends or, of a loop, around it.
Expected<BetaShape> shape_with_ghosts(std::size_t keys, const FamilySettings& settings) {
  if (settings.closure) return auxiliary_shape(settings, keys);
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

/// The points whose joints are the keys.
template <CurvePoint P>
Expected<std::vector<P>> solved_points(std::span<const P> keys, const BetaShape& shape,
                                       const FamilySettings& settings) {
  return control_points_through(keys, BetaThrough::info.name, JointToKey<double>{&shape}, settings.closure);
}

template <CurvePoint P>
std::vector<P> with_ghosts(std::span<const P> solved, const FamilySettings& settings) {
  if (settings.closure) return points_around(solved, *settings.closure);
  const auto points = reflected(solved);
  std::vector<P> all{points[-1]};
  all.insert(all.end(), solved.begin(), solved.end());
  all.push_back(points[static_cast<std::ptrdiff_t>(solved.size())]);
  return all;
}

}  // namespace

Expected<BetaThrough::Construction> BetaThrough::construction(const Keyframes& keys, const FamilySettings& settings) {
  return shape_with_ghosts(keys.size(), settings).and_then([&](const BetaShape& shape) {
    return solved_points(keys.orientations(), shape, settings).map([&](auto points) {
      return Construction{shape, std::move(points)};
    });
  });
}

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> BetaThrough::curve(const Keyframes& keys,
                                                                  const FamilySettings& settings) {
  return shape_with_ghosts(keys.size(), settings).and_then([&](const BetaShape& shape) {
    return solved_points(keys.points<P>(), shape, settings).map([&](const std::vector<P>& solved) {
      const std::vector<P> points = with_ghosts(std::span<const P>(solved), settings);
      return CumulativeCurve<CubicBezierBasis, P>(four_key_knots(keys, settings), {},
                                                  beta_polygon(std::span<const P>(points), shape));
    });
  });
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> BetaThrough::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> BetaThrough::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
