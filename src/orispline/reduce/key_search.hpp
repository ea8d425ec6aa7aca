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

/// Few samples that are keys of a curve within the tolerance.
///
/// Insertion: in every round the worst sample of every segment that breaks the tolerance, from the two ends on. Then
/// pruning: keys that the curve can do without are taken out. Then exchange: two keys for one, by taking out a key and
/// moving its neighbours to other samples by fixed shares of the gap.
[[nodiscard]] Expected<KeySet> selected_keys(const LocalMethod& method, const ToleranceCheck& recording);

/// Takes out more keys where the rest can be moved so that the curve is within the tolerance again.
///
/// A key moves by the mean of what is missed around it, weighted by its hat function and by the squared miss
/// (progressive iterative approximation: Deng and Lin, Computer-Aided Design 47, 2014, with weights of our own), which
/// needs no derivatives. The times of the keys stay. The curve is within the tolerance before and after.
[[nodiscard]] Expected<KeySet> with_keys_refitted(const LocalMethod& method, const ToleranceCheck& recording,
                                                  KeySet keys);

}}  // namespace orispline
