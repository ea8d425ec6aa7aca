// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta.hpp>

#include <orispline/families/betas.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> Beta::curve(const Keyframes& keys, const FamilySettings& settings) {
  return auxiliary_shape(settings, keys.size()).map([&](const BetaShape& shape) {
    return CumulativeCurve<CubicBezierBasis, P>(published_knots(keys, settings), {},
                                                published_polygon<P>(keys, settings, shape));
  });
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> Beta::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> Beta::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
