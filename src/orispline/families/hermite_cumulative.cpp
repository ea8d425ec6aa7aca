// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/hermite_cumulative.hpp>

#include <orispline/curve/three_key_rates.hpp>

namespace orispline::families {
namespace {

std::vector<Eigen::Vector3d> key_rates(const Keyframes& keys) {
  if (const auto given = keys.angular_velocities(); !given.empty()) return {given.begin(), given.end()};
  const auto q = keys.orientations();
  std::vector<Eigen::Vector3d> increments;
  increments.reserve(q.size() - 1);
  for (std::size_t i = 0; i + 1 < q.size(); ++i) increments.push_back(increment<double>(q[i], q[i + 1]));
  return three_key_rates(keys.times(), increments);
}

}  // namespace

Expected<CubicBezierCurve> HermiteCumulative::curve(const Keyframes& keys, const FamilySettings& settings) {
  const PerKey tension = settings.per_key("tension");
  std::vector<Eigen::Vector3d> rates = key_rates(keys);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] *= tension[i];
  return hermite_curve(Knots({keys.times().begin(), keys.times().end()}), keys.orientations(), rates);
}

}  // namespace orispline::families
