// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_start.hpp>

#include <algorithm>

#include <orispline/base/expect.hpp>
#include <orispline/smooth/smoothing_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

SmoothedNodes recorded_nodes(const SmoothingProblem& problem) {
  const auto first = std::ranges::find_if(problem.weights, [](double w) { return w > 0.0; });
  ORISPLINE_EXPECT(first != problem.weights.end());
  auto latest = static_cast<std::size_t>(first - problem.weights.begin());
  SmoothedNodes nodes;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (problem.weights[i] > 0.0) latest = i;
    nodes.orientations.push_back(problem.orientations[latest]);
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, problem.size() - 1);
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (std::size_t k = before; k < after; ++k)
      way += shortest_increment(nodes.orientations[k], nodes.orientations[k + 1]);
    nodes.angular_velocities.emplace_back(way / (problem.times[after] - problem.times[before]));
  }
  nodes.angular_accelerations.assign(problem.size(), Eigen::Vector3d::Zero());
  return nodes;
}

}}  // namespace orispline
