// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Smallest, median and largest of a row of figures, and where the largest stands.
struct Spread {
  double smallest = 0.0, median = 0.0, largest = 0.0;
  std::size_t largest_at = 0;  ///< index of the first largest one
};

/// At least one figure, none of them NaN. The median of an even number is the mean of the middle two.
[[nodiscard]] ORISPLINE_EXPORT Spread spread_of(std::vector<double> figures);

}}  // namespace orispline
