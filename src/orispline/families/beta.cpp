// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta.hpp>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/key_knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

Expected<BetaShape> shape_of(std::size_t points, const FamilySettings& settings) {
  return beta_shape("beta", settings.per_key("beta1").all(points), settings.per_key("beta2").all(points));
}

}  // namespace

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> Beta::curve(const Keyframes& keys, const FamilySettings& settings) {
  return shape_of(keys.size(), settings).map([&](const BetaShape& shape) {
    return CumulativeCurve<CubicBezierBasis, P>(inner_key_knots(keys), {}, beta_polygon(keys.points<P>(), shape));
  });
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> Beta::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> Beta::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
