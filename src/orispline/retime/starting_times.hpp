// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a retiming starts from.
struct StartingTimes {
  std::vector<double> times;                  ///< of the keys [s]
  std::vector<double> least;                  ///< what the intervals between them may be cut to [s]
  std::vector<std::vector<double>> others{};  ///< times from which the way down may end lower [s]
};

/// Those of the keys, with long rests cut, below which no interval may get. Several bodies have the same times.
///
/// For Slowing::fastest_keys nothing of the times that were typed but the rests: each interval takes half of the
/// longest (x/L)^(1/k), x what the step to the next key changes most, in any body, of a quantity with the limit L and
/// the order k. Its others are the times at which RestToRest is at the keys, from each rest to the next. Error
/// (bad_argument, with the key): nothing that is limited changes from a key to the next.
[[nodiscard]] Expected<StartingTimes> starting_times(std::span<const Keyframes> bodies, const RetimeOptions& options);

/// Whether all bodies rest from a key to the next.
[[nodiscard]] bool all_rest_after(std::span<const Keyframes> bodies, std::size_t key);

}}  // namespace orispline
