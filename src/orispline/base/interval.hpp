// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Numbers from the lowest to the highest, both included; all by default.
struct Interval {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();

  [[nodiscard]] constexpr bool contains(double x) const noexcept { return lowest <= x && x <= highest; }
};

}}  // namespace orispline
