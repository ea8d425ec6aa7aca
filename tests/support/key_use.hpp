// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// Which keys a curve passes through on any times.
enum class Touches { every_key, joints, nothing };

/// What families that are not plain interpolants say about their keys in words: where the curve runs, what it touches.
struct KeyUse {
  std::size_t first_key = 0;  ///< the curve begins at this key's time and ends as many keys before the last
  std::size_t stride = 1;     ///< keys from one joint to the next
  Touches touches = Touches::every_key;
  std::size_t further_times = 0;      ///< times on either side that a segment depends on beyond those of its keys
  bool parameters_reach_far = false;  ///< a parameter acts on every segment that its key acts on, not on two only
  bool feels_times = true;            ///< else the key times stretch segments that are formed without them
  bool solved = false;                ///< every segment feels every key, the further the less
  double widest_turn = 10.0;  ///< between keys at uneven times [rad]: wider ones may be refused as not converged
  int smoothest_with_parameters = 9;  ///< order of continuity that parameters other than the default ones leave

  /// Keys for a curve of that many segments.
  [[nodiscard]] std::size_t keys_for(std::size_t segments) const { return 2 * first_key + stride * segments + 1; }
  /// The largest number of keys the family takes, up to `keys`.
  [[nodiscard]] std::size_t cut(std::size_t keys) const { return keys_for((keys - 2 * first_key - 1) / stride); }
  /// The step of a random walk on such times [rad]: as wide as asked for, or as the family takes.
  [[nodiscard]] double step_on(Spacing spacing, double wanted) const {
    return spacing == Spacing::even ? wanted : std::min(wanted, widest_turn);
  }
  /// Hard keys may be answered by the error that the equations of the method were not solved for them.
  [[nodiscard]] bool may_refuse() const { return widest_turn < 10.0; }
  [[nodiscard]] bool touches_key(std::size_t key) const {
    return touches == Touches::every_key || (touches == Touches::joints && key % stride == 0);
  }
};

[[nodiscard]] inline KeyUse key_use(const FamilyInfo& family) {
  if (family.name == "beta" || family.name == "beta-g2")
    return {.first_key = 1, .touches = Touches::nothing, .parameters_reach_far = true};
  if (family.name == "bezier") return {.stride = 3, .touches = Touches::joints};
  if (family.name == "bspline") return {.touches = Touches::nothing, .further_times = 1};
  // Control points of keys at uneven times lie far outside the keys' own arcs.
  if (family.name == "bspline-through" || family.name == "nu")
    return {.parameters_reach_far = true, .solved = true, .widest_turn = 0.8};
  if (family.name == "averages") return {.parameters_reach_far = true, .solved = true, .widest_turn = 0.5};
  if (family.name == "barry-goldman") return {.widest_turn = 0.8};  // its geodesics go on for ten times their length
  // Tension by a jump of the acceleration.
  if (family.name == "global-c2" || family.name == "nu-exact")
    return {.parameters_reach_far = true, .solved = true, .smoothest_with_parameters = 1};
  if (family.name == "beta-through") return {.parameters_reach_far = true, .feels_times = false, .solved = true};
  if (family.support_keys == all_keys) return {.parameters_reach_far = true, .solved = true};
  return {};
}

}  // namespace orispline::testing_support
