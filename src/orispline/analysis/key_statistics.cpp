// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/key_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/expect.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>

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

KeyStatistics key_statistics(const Keyframes& keys) {
  const auto t = keys.times();
  const auto q = keys.orientations();
  if (keys.size() < 2) return {};
  KeyStatistics statistics{.span = t.back() - t.front()};
  std::vector<double> spacings, steps;
  spacings.reserve(keys.size() - 1);
  steps.reserve(keys.size() - 1);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    spacings.push_back(t[i + 1] - t[i]);
    steps.push_back(increment<double>(q[i], q[i + 1]).norm());
    const bool is_motion = t[i + 1] > t[i];
    if (is_motion && std::abs(steps.back() - std::numbers::pi) <= half_turn_margin)
      statistics.near_half_turns.push_back(i);
  }
  statistics.spacing = spread_of(std::move(spacings));
  statistics.step = spread_of(std::move(steps));
  return statistics;
}

}}  // namespace orispline
