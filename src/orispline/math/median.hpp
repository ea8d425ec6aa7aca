// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <orispline/base/expect.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// The middle one of some numbers, or the mean of the two in the middle.
[[nodiscard]] inline double median(std::vector<double> numbers) {
  ORISPLINE_EXPECT(!numbers.empty());
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  if (numbers.size() % 2 != 0) return *middle;
  return 0.5 * (*middle + *std::max_element(numbers.begin(), middle));
}

}  // namespace orispline::inline ORISPLINE_ABI
