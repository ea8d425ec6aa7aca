// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/hermite_cumulative.hpp>

#include <algorithm>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/three_key_rates.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

std::vector<Eigen::Vector3d> HermiteCumulative::key_rates(const Keyframes& keys) {
  const auto given = keys.angular_velocities();
  if (!given.empty() && std::ranges::none_of(given, is_free)) return {given.begin(), given.end()};
  std::vector<Eigen::Vector3d> rates = three_key_rates(keys.times(), increments_between(keys.orientations()));
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!is_free(given[i])) rates[i] = given[i];
  return rates;
}

Expected<CubicBezierCurve> HermiteCumulative::curve(const Keyframes& keys, const FamilySettings& settings) {
  const PerKey tension = settings.per_key("tension");
  std::vector<Eigen::Vector3d> rates = key_rates(keys);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] *= tension[i];
  return hermite_curve(key_knots(keys), keys.orientations(), rates);
}

}}}  // namespace orispline::families
