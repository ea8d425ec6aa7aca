// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/spread.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/expect.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Spread spread_of(std::vector<double> figures) {
  ORISPLINE_EXPECT(!figures.empty());
  const auto [least, greatest] = std::ranges::minmax_element(figures);
  const auto largest = std::ranges::max_element(figures);  // minmax_element would name the last of equal ones
  Spread spread{.smallest = *least,
                .median = 0.0,
                .largest = *greatest,
                .largest_at = static_cast<std::size_t>(largest - figures.begin())};
  spread.median = median(std::move(figures));
  return spread;
}

}}  // namespace orispline
