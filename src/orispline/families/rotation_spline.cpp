// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/rotation_spline.hpp>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/rate_chain.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

Expected<ChartCurve<3>> RotationSpline::curve(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  const std::vector<Eigen::Quaterniond> joints = joint_orientations(keys, settings);
  const std::vector<Eigen::Vector3d> increments = increments_between(joints);
  const auto only = [](const Eigen::Vector3d& rate) {
    return std::array<Eigen::Vector3d, 3>{rate, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  };
  return solve_rates<LeftChartPiece>(info.name, increments, knots, rate_conditions(settings, increments, knots))
      .map([&](const std::vector<Eigen::Vector3d>& rates) {
        std::vector<ChartPiece<3>> pieces;
        pieces.reserve(increments.size());
        for (std::size_t i = 0; i < increments.size(); ++i)
          pieces.push_back(
              hermite_piece<1>(joints[i], increments[i], only(rates[i]), only(rates[i + 1]), knots.span(i).step()));
        return ChartCurve<3>(std::move(knots), std::move(pieces));
      });
}

Expected<HermitePath<3>> RotationSpline::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}}}  // namespace orispline::families
