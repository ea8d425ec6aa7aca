// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/math/so3.hpp>

namespace orispline {

/// From each orientation to the next: n of them give n-1 rotation vectors [rad].
[[nodiscard]] std::vector<Eigen::Vector3d> increments_between(std::span<const Eigen::Quaterniond> keys);

/// From each position to the next [m].
[[nodiscard]] std::vector<Eigen::Vector3d> increments_between(std::span<const Eigen::Vector3d> positions);

}  // namespace orispline
