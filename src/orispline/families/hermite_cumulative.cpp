// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/hermite_cumulative.hpp>

#include <orispline/curve/increments.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/three_key_rates.hpp>

namespace orispline::inline ORISPLINE_ABI::families {

std::vector<Eigen::Vector3d> HermiteCumulative::key_rates(const Keyframes& keys) {
  if (const auto given = keys.angular_velocities(); !given.empty()) return {given.begin(), given.end()};
  return three_key_rates(keys.times(), increments_between(keys.orientations()));
}

Expected<CubicBezierCurve> HermiteCumulative::curve(const Keyframes& keys, const FamilySettings& settings) {
  const PerKey tension = settings.per_key("tension");
  std::vector<Eigen::Vector3d> rates = key_rates(keys);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] *= tension[i];
  return hermite_curve(key_knots(keys), keys.orientations(), rates);
}

}  // namespace orispline::inline ORISPLINE_ABI::families
