// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// So much of an increment is rounding [rad], and of a rate of order k over steps of h seconds so much over h^k.
inline constexpr double rounding_of_increments = 256.0 * std::numeric_limits<double>::epsilon();

/// A rate of this order is rounding altogether, between keys that are `step` seconds apart [rad/s^order].
[[nodiscard]] constexpr double rounding_of_rates(double step, int order) noexcept {
  double rounding = rounding_of_increments;
  for (int k = 0; k < order; ++k) rounding /= step;
  return rounding;
}

}}  // namespace orispline
