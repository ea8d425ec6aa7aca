// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/increments.hpp>

namespace orispline {

std::vector<Eigen::Vector3d> increments_between(std::span<const Eigen::Quaterniond> keys) {
  std::vector<Eigen::Vector3d> increments;
  increments.reserve(keys.size());
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) increments.push_back(increment<double>(keys[i], keys[i + 1]));
  return increments;
}

std::vector<Eigen::Vector3d> increments_between(std::span<const Eigen::Vector3d> positions) {
  std::vector<Eigen::Vector3d> increments;
  increments.reserve(positions.size());
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) increments.push_back(positions[i + 1] - positions[i]);
  return increments;
}

}  // namespace orispline
