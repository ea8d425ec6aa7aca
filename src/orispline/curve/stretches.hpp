// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Successive keys without a gap or a jump.
struct Stretch {
  std::size_t first, count;
};

/// Rising times cut where the motion jumps, which is where two are equal, and where an interval is longer than the gap
/// [s], if there is one. Error (bad_argument): a gap that is not longer than the median interval.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Stretch>> stretches_between_gaps(std::span<const double> times,
                                                                                     std::optional<double> gap);

/// Whether keys are to be cut: a gap is stated, or the motion jumps.
[[nodiscard]] inline bool are_in_stretches(const Keyframes& keys, std::optional<double> gap) noexcept {
  return gap || keys.data().jumps;
}

}}  // namespace orispline
