// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/global_c2.hpp>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/handle_curve.hpp>
#include <orispline/curve/rate_chain.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

Expected<SlerpBezierCurve> solved_curve(std::string_view method, const Keyframes& keys,
                                        const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  const std::vector<Eigen::Quaterniond> joints = joint_orientations(keys, settings);
  const std::vector<Eigen::Vector3d> increments = increments_between(joints);
  return solve_rates<SlerpBezierPiece>(method, increments, knots, rate_conditions(settings, increments, knots))
      .map([&](const std::vector<Eigen::Vector3d>& rates) {
        return handle_curve<Eigen::Quaterniond>(std::move(knots), joints, rates, rates);
      });
}

}  // namespace

Expected<SlerpBezierCurve> GlobalC2::curve(const Keyframes& keys, const FamilySettings& settings) {
  return solved_curve(info.name, keys, settings);
}
Expected<HermitePath<3>> GlobalC2::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}
Expected<RateChain<SlerpBezierPiece>> NuExact::rates(const Keyframes& keys, const FamilySettings& settings) {
  const Knots knots = four_key_knots(keys, settings);
  const std::vector<Eigen::Vector3d> increments = increments_between(joint_orientations(keys, settings));
  return solved_rate_chain<SlerpBezierPiece>(info.name, increments, knots,
                                             rate_conditions(settings, increments, knots));
}
Expected<SlerpBezierCurve> NuExact::curve(const Keyframes& keys, const FamilySettings& settings) {
  return solved_curve(info.name, keys, settings);
}
Expected<HermitePath<3>> NuExact::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}}}  // namespace orispline::families
