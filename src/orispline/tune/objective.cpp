// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/objective.hpp>

#include <algorithm>

#include <orispline/analysis/rounding.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

double rounding_of(const Goal& goal, const Keyframes& keys) noexcept {
  if (goal.objective == Objective::fit) return rounding_of_increments * rounding_of_increments;
  const int order = goal.objective == Objective::jerk ? 3 : 2;
  const double moment = goal.objective == Objective::torque ? goal.inertia.norm() : 1.0;
  const auto times = keys.times();
  const auto step = [&](std::size_t i) { return times[i + 1] - times[i]; };
  // Of the curvature, for a body that turns as fast as from key to key; where it does not turn there is no path.
  const auto weight = [&](std::size_t i) {
    if (goal.objective != Objective::curvature) return 1.0;
    const double rate = angular_distance(keys.orientations()[i], keys.orientations()[i + 1]) / step(i);
    return rate > rounding_of_rates(step(i), 1) ? 1.0 / (rate * rate * rate) : 0.0;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    double shortest = step(i);
    if (i > 0) shortest = std::min(shortest, step(i - 1));
    if (i + 2 < times.size()) shortest = std::min(shortest, step(i + 1));
    const double rate = moment * rounding_of_rates(shortest, order);
    sum += step(i) * rate * rate * weight(i);
  }
  return sum;
}

}}  // namespace orispline
