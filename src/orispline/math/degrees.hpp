// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

inline constexpr double degrees = 180.0 / std::numbers::pi;  ///< in a radian, for what is shown
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

}}  // namespace orispline
