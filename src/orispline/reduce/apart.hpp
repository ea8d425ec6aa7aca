// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far two values of a channel are apart: an angle [rad], or a length.
[[nodiscard]] inline double apart(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) noexcept {
  return angular_distance(a, b);
}
[[nodiscard]] inline double apart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return (a - b).norm();
}

}}  // namespace orispline
