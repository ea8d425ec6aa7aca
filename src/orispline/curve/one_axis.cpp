// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/one_axis.hpp>

#include <algorithm>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

bool have_one_axis(std::span<const Eigen::Vector3d> turns) noexcept {
  const auto norm = [](const Eigen::Vector3d& turn) { return turn.norm(); };
  const Eigen::Vector3d axis = std::ranges::max(turns, {}, norm).stableNormalized();
  return std::ranges::all_of(turns, [&](const Eigen::Vector3d& turn) {
    return axis.cross(turn).norm() <= one_axis_tolerance * std::max(1.0, turn.norm());
  });
}

Eigen::Vector3d increment_near(const Eigen::Vector3d& estimate, const Eigen::Quaterniond& from,
                               const Eigen::Quaterniond& to) noexcept {
  const Eigen::Vector3d found = increment<double>(from, to);
  const Eigen::Vector3d axis = (found.isZero(0.0) ? estimate : found).stableNormalized();
  const double turns = std::round((estimate - found).dot(axis) / (2.0 * full_turn));  // two of the body are one of q
  return found + 2.0 * full_turn * turns * axis;
}

}}  // namespace orispline
