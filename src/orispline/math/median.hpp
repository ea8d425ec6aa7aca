// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The middle one of some numbers, or the mean of the two in the middle; 0 of none.
[[nodiscard]] inline double median(std::vector<double> numbers) {
  if (numbers.empty()) return 0.0;
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  if (numbers.size() % 2 != 0) return *middle;
  return 0.5 * (*middle + *std::max_element(numbers.begin(), middle));
}

/// Of successive times; 0 for fewer than two.
[[nodiscard]] inline double median_interval(std::span<const double> times) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  return median(std::move(intervals));
}

}}  // namespace orispline
