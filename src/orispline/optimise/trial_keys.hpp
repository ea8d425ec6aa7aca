// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/optimise/recording.hpp>

namespace orispline::optimise {

/// Which inner keys may be worth a trial without them, and which of those can be tried at once.
class TrialKeys {
 public:
  /// Of that many keys; two that are tried at once are at least `apart` from each other.
  TrialKeys(std::size_t keys, std::size_t apart) : open_(keys, true), apart_(apart) {}

  /// Indices of keys, rising; empty when no trial is left.
  [[nodiscard]] std::vector<std::size_t> next() const;
  /// The curve needs the key.
  void keep(std::size_t key) { open_[key] = false; }
  /// Those are gone: the keys near them are worth another trial.
  void remove(const std::vector<std::size_t>& removed);

 private:
  std::vector<bool> open_;
  std::size_t apart_;
};

/// The keys but for those at the given indices, which rise.
[[nodiscard]] KeySet without(const KeySet& keys, const std::vector<std::size_t>& removed);

/// The segment that took the place of the two beside the m-th of the removed keys.
[[nodiscard]] inline std::size_t merged_segment(const std::vector<std::size_t>& removed, std::size_t m) {
  return removed[m] - 1 - m;
}

/// The removed keys whose merged segment is the nearest one to a segment that breaks the tolerance.
[[nodiscard]] std::vector<std::size_t> missed_keys(const std::vector<std::size_t>& removed,
                                                   const std::vector<WorstSample>& worst);

}  // namespace orispline::optimise
