// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/key_statistics.hpp>

#include <orispline/math/so3.hpp>

#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

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
    if (std::abs(steps.back() - std::numbers::pi) <= half_turn_margin) statistics.near_half_turns.push_back(i);
  }
  statistics.spacing = spread_of(std::move(spacings));
  statistics.step = spread_of(std::move(steps));
  return statistics;
}

}}  // namespace orispline
