// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bezier.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

Knots joint_knots(const Keyframes& keys) {
  std::vector<double> times;
  times.reserve(keys.size() / 3 + 1);
  for (std::size_t i = 0; i < keys.size(); i += 3) times.push_back(keys.times()[i]);
  return Knots(std::move(times));
}

}  // namespace

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> Bezier::curve(const Keyframes& keys, const FamilySettings&) {
  return CumulativeCurve<CubicBezierBasis, P>(joint_knots(keys), {}, keys.points<P>());
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> Bezier::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> Bezier::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}}}  // namespace orispline::families
