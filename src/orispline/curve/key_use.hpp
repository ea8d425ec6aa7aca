// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a family uses the keys of a curve, beyond passing through all of them and blending its neighbours.
struct KeyUse {
  std::size_t first = 0;              ///< the curve begins at this key's time and ends as many keys before the last
  std::size_t stride = 1;             ///< keys from one joint to the next; the curve passes through these at least
  std::size_t further_times = 0;      ///< times on either side that a segment depends on beyond those of its keys
  bool parameters_reach_far = false;  ///< a parameter acts on every segment that its key acts on, not on two only
  bool feels_times = true;            ///< else the key times stretch segments that are formed without them
  double widest_turn = 10.0;  ///< between keys at uneven times [rad]: wider ones lead astray or may not converge
  int smoothest_with_parameters = 9;  ///< order of continuity that parameters other than the default ones leave

  /// Keys for a curve of that many segments.
  [[nodiscard]] constexpr std::size_t keys_for(std::size_t segments) const noexcept {
    return 2 * first + stride * segments + 1;
  }
  /// The largest number of keys that a curve takes, up to `keys`, which are enough for a segment.
  [[nodiscard]] constexpr std::size_t cut(std::size_t keys) const noexcept {
    return keys_for((keys - 2 * first - 1) / stride);
  }
};

}}  // namespace orispline
