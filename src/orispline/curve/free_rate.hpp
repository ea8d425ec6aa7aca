// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include <orispline/base/abi.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What stands for a rate that a key leaves free, so that a method chooses or estimates it there: three NaN.
[[nodiscard]] inline Eigen::Vector3d free_rate() noexcept {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

[[nodiscard]] inline bool is_free(const Eigen::Vector3d& rate) noexcept { return rate.array().isNaN().all(); }

/// Whether some key has a rate: there are rates, and not all of them are free.
[[nodiscard]] inline bool any_given(std::span<const Eigen::Vector3d> rates) noexcept {
  return !std::ranges::all_of(rates, is_free);
}

}}  // namespace orispline
