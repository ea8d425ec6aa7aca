// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace orispline {

inline constexpr double degrees = 180.0 / std::numbers::pi;  ///< in a radian, for what is shown

}  // namespace orispline
