// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/keyframe.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// With more keys the least energy is not looked for, which takes a quarter of a millisecond a key.
inline constexpr std::size_t most_keys_for_least_energy = 10000;

/// ∫|α|² dt [rad²/s³] of the method `least` through the orientations, with free ends and whatever rates the keys have.
/// Absent for fewer than two keys, for more than `most_keys_for_least_energy`, and where the optimum was not found.
[[nodiscard]] ORISPLINE_EXPORT std::optional<double> least_energy(const Keyframes& keys);

/// Which of the tracks have equal times and orientations: for each the index of the first that is equal to it.
[[nodiscard]] std::vector<std::size_t> first_of_equal(std::span<const Keyframes* const> tracks);

}  // namespace orispline::inline ORISPLINE_ABI
