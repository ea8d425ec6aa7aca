// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <orispline/reduce/tolerance_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A local method, as far as it concerns the search for keys: moving a key changes `reach` segments on either side.
struct LocalMethod {
  Method method;  ///< its settings are those of the samples
  std::size_t reach;
};

/// What is done to the keys that remain so that they make up for those that were taken out.
struct Repair {
  std::size_t keys_moved = 0;  ///< on either side of a key that was taken out; no others may be touched
  /// The indices of the removed keys, rising, and the keys without them, to be repaired.
  std::function<Expected<void>(const std::vector<std::size_t>& removed, KeySet& rest)> apply{};
};

/// Takes out keys as long as the curve is within the tolerance: many at once, so far apart that no segment feels two of
/// them, until every key that is left has failed since its surroundings changed.
///
/// The curve is within the tolerance before and after. Errors: those of make_pose_curve() and of the repair.
[[nodiscard]] Expected<KeySet> with_keys_removed(const LocalMethod& method, const ToleranceCheck& recording,
                                                 KeySet keys, const Repair& repair);

/// The segment that took the place of the two beside the m-th of the removed keys.
[[nodiscard]] inline std::size_t merged_segment(const std::vector<std::size_t>& removed, std::size_t m) {
  return removed[m] - 1 - m;
}

/// The removed keys whose merged segment is the nearest one to a segment that breaks the tolerance.
[[nodiscard]] std::vector<std::size_t> missed_keys(const std::vector<std::size_t>& removed,
                                                   const std::vector<WorstSample>& worst);

}}  // namespace orispline
