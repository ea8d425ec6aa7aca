// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Smallest, median and largest of a row of figures, and where the largest stands.
struct Spread {
  double smallest = 0.0, median = 0.0, largest = 0.0;
  std::size_t largest_at = 0;  ///< index of the first largest one
};

/// At least one figure, none of them NaN. The median of an even number is the mean of the middle two.
[[nodiscard]] ORISPLINE_EXPORT Spread spread_of(std::vector<double> figures);

/// What the keys are like, before any curve is drawn through them.
struct KeyStatistics {
  double span = 0.0;                           ///< last time minus first [s]
  std::optional<Spread> spacing{};             ///< times between neighbouring keys [s]; absent for one key
  std::optional<Spread> step{};                ///< angles between neighbouring keys [rad]; index i: from key i to i+1
  std::vector<std::size_t> near_half_turns{};  ///< i where the step from key i to i+1 is ambiguous
};

[[nodiscard]] ORISPLINE_EXPORT KeyStatistics key_statistics(const Keyframes& keys);

}}  // namespace orispline
