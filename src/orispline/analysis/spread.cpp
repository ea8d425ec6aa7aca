// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/spread.hpp>

#include <algorithm>

#include <orispline/base/expect.hpp>

namespace orispline::inline ORISPLINE_ABI {

Spread spread_of(std::vector<double> figures) {
  ORISPLINE_EXPECT(!figures.empty());
  const auto [least, greatest] = std::ranges::minmax_element(figures);
  const auto largest = std::ranges::max_element(figures);  // minmax_element would name the last of equal ones
  Spread spread{.smallest = *least,
                .median = 0.0,
                .largest = *greatest,
                .largest_at = static_cast<std::size_t>(largest - figures.begin())};
  const auto middle = figures.begin() + static_cast<std::ptrdiff_t>(figures.size() / 2);
  std::ranges::nth_element(figures, middle);
  spread.median = *middle;
  if (figures.size() % 2 == 0) spread.median = 0.5 * (*middle + *std::max_element(figures.begin(), middle));
  return spread;
}

}  // namespace orispline::inline ORISPLINE_ABI
