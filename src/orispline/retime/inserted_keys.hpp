// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Keys that are put on a path are so far apart, in what is taken for a rest.
inline constexpr double least_moves = 4.0;

/// How many keys are put into each interval between keys: into the first and the last one of what lies between two
/// rests or ends, where the motion starts and stops, and into the others.
struct KeysPerInterval {
  std::size_t at_ends, inside;
};

/// Keys, and which of them are new.
struct MoreKeys {
  Keyframes keys;
  std::vector<std::size_t> inserted;  ///< in order
};

/// The keys of a curve, and between them others that lie on it, at even times of their interval. None is put into a
/// rest, or so near to another one that both would pass for one.
[[nodiscard]] Expected<MoreKeys> with_more_keys(const Keyframes& keys, const PoseCurve& curve,
                                                const KeysPerInterval& count);

}}  // namespace orispline
