// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include <orispline/analysis/spread.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the keys are like, before any curve is drawn through them.
struct KeyStatistics {
  double span = 0.0;                           ///< last time minus first [s]
  std::optional<Spread> spacing{};             ///< times between neighbouring keys [s]; absent for one key
  std::optional<Spread> step{};                ///< angles between neighbouring keys [rad]; index i: from key i to i+1
  std::vector<std::size_t> near_half_turns{};  ///< i where the step from key i to i+1 is ambiguous
};

[[nodiscard]] ORISPLINE_EXPORT KeyStatistics key_statistics(const Keyframes& keys);

}}  // namespace orispline
