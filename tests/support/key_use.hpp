// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/curve/family.hpp>

namespace orispline::testing_support {

/// Which keys a curve passes through on any times.
enum class Touches { every_key, joints, nothing };

/// What families that are not plain interpolants say about their keys in words: where the curve runs, what it touches.
struct KeyUse {
  std::size_t first_key = 0;  ///< the curve begins at this key's time and ends as many keys before the last
  std::size_t stride = 1;     ///< keys from one joint to the next
  Touches touches = Touches::every_key;
  std::size_t further_times = 0;  ///< times on either side that a segment depends on beyond those of its keys
  /// Between keys at uneven times [rad]: beyond it a method may be refused as not converged, or bend too sharply for
  /// the differences that tests take.
  double widest_turn = 10.0;
  bool parameters_reach_far = false;  ///< a parameter acts on every segment that its key acts on, not on two only

  /// Keys for a curve of that many segments.
  [[nodiscard]] std::size_t keys_for(std::size_t segments) const { return 2 * first_key + stride * segments + 1; }
  /// The largest number of keys the family takes, up to `keys`.
  [[nodiscard]] std::size_t cut(std::size_t keys) const { return keys_for((keys - 2 * first_key - 1) / stride); }
  [[nodiscard]] bool touches_key(std::size_t key) const {
    return touches == Touches::every_key || (touches == Touches::joints && key % stride == 0);
  }
};

[[nodiscard]] inline KeyUse key_use(const FamilyInfo& family) {
  if (family.name == "beta" || family.name == "beta-g2")
    return {.first_key = 1, .touches = Touches::nothing, .parameters_reach_far = true};
  if (family.name == "bezier") return {.stride = 3, .touches = Touches::joints};
  if (family.name == "bspline") return {.touches = Touches::nothing, .further_times = 1};
  const bool global = family.support_keys == all_keys;
  // Control points of keys at uneven times lie far outside the keys' own arcs.
  if (family.name == "bspline-through" || family.name == "nu")
    return {.widest_turn = 0.8, .parameters_reach_far = global};
  if (family.name == "averages") return {.widest_turn = 0.5, .parameters_reach_far = global};
  if (family.name == "barry-goldman") return {.widest_turn = 0.8};  // its geodesics go on for ten times their length
  return {.parameters_reach_far = global};
}

}  // namespace orispline::testing_support
