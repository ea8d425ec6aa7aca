// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// With more keys the least energy is not looked for, which takes a quarter of a millisecond a key.
inline constexpr std::size_t most_keys_for_least_energy = 10000;

/// ∫|α|² dt [rad²/s³] of the method `least` through the orientations, with free ends and whatever rates the keys have.
/// Absent for fewer than two keys, for more than `most_keys_for_least_energy`, and where the optimum was not found.
[[nodiscard]] ORISPLINE_EXPORT std::optional<double> least_energy(const Keyframes& keys);

}}  // namespace orispline
