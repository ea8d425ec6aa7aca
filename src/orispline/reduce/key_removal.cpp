// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/key_removal.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Which inner keys may be worth a trial without them, and which of those can be tried at once.
class TrialKeys {
 public:
  /// Of that many keys; two that are tried at once are at least `apart` from each other.
  TrialKeys(std::size_t keys, std::size_t apart) : open_(keys, true), apart_(apart) {}

  /// Indices of keys, rising; empty when no trial is left.
  [[nodiscard]] std::vector<std::size_t> next() const {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 1; i + 1 < open_.size(); ++i)
      if (open_[i] && (chosen.empty() || i - chosen.back() >= apart_)) chosen.push_back(i);
    return chosen;
  }

  /// The curve needs the key.
  void keep(std::size_t key) { open_[key] = false; }

  /// Those are gone: the keys near them are worth another trial.
  void remove(const std::vector<std::size_t>& removed) {
    for (const std::size_t key : removed) {
      const std::size_t first = key - std::min(key, apart_), end = std::min(open_.size(), key + apart_ + 1);
      for (std::size_t i = first; i < end; ++i) open_[i] = true;
    }
    std::vector<bool> rest;
    auto gone = removed.begin();
    for (std::size_t i = 0; i < open_.size(); ++i)
      if (gone != removed.end() && *gone == i) ++gone;
      else rest.push_back(open_[i]);
    open_ = std::move(rest);
  }

 private:
  std::vector<bool> open_;
  std::size_t apart_;
};

void copy_key(const KeySet& from, std::size_t i, KeySet& to, std::size_t k) {
  to.samples[k] = from.samples[i];
  to.orientations[k] = from.orientations[i];
  if (!from.positions.empty()) to.positions[k] = from.positions[i];
}

/// The keys but for those at the given indices, which rise.
KeySet without(KeySet keys, const std::vector<std::size_t>& removed) {
  std::size_t kept = 0;
  auto gone = removed.begin();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (gone != removed.end() && *gone == i) ++gone;
    else copy_key(keys, i, keys, kept++);
  }
  keys.samples.resize(kept);
  keys.orientations.resize(kept);
  if (!keys.positions.empty()) keys.positions.resize(kept);
  return keys;
}

class Removal {
 public:
  Removal(const LocalMethod& method, const ToleranceCheck& recording, const Repair& repair, KeySet keys)
      : method_(method),
        recording_(recording),
        repair_(repair),
        keys_(std::move(keys)),
        trials_(keys_.size(), 2 * (method.reach + repair.keys_moved) + 1) {}

  Expected<KeySet> run() && {
    for (auto removed = trials_.next(); !removed.empty(); removed = trials_.next()) {
      KeySet trial = without(keys_, removed);
      if (repair_.apply)
        if (auto repaired = repair_.apply(removed, trial); !repaired)
          return tl::unexpected(std::move(repaired.error()));
      if (auto settled = settle(std::move(removed), std::move(trial)); !settled)
        return tl::unexpected(std::move(settled.error()));
    }
    return std::move(keys_);
  }

 private:
  /// Keeps what holds and gives back the other keys, with their neighbours as they were.
  Expected<void> settle(std::vector<std::size_t> removed, KeySet trial) {
    while (!removed.empty()) {
      const auto worst = recording_.worst_samples(method_.method, trial);
      if (!worst) return tl::unexpected(worst.error());
      const auto missed = missed_keys(removed, *worst);
      if (missed.empty()) break;
      for (const std::size_t key : missed) trials_.keep(key);
      give_back(missed, removed, trial);
    }
    if (removed.empty()) return {};
    keys_ = std::move(trial);
    trials_.remove(removed);
    return {};
  }

  void give_back(const std::vector<std::size_t>& missed, std::vector<std::size_t>& removed, KeySet& trial) const {
    KeySet full = keys_;
    std::vector<std::size_t> gone;
    for (std::size_t m = 0; m < removed.size(); ++m) {
      if (std::ranges::binary_search(missed, removed[m])) continue;
      gone.push_back(removed[m]);
      const std::size_t after = merged_segment(removed, m) + 1;  // the key behind the removed one
      for (std::size_t k = after - std::min(after, repair_.keys_moved);
           k < std::min(trial.size(), after + repair_.keys_moved); ++k)
        copy_key(trial, k, full, k + m + (k >= after ? 1 : 0));
    }
    removed = std::move(gone);
    trial = without(std::move(full), removed);
  }

  LocalMethod method_;
  const ToleranceCheck& recording_;
  const Repair& repair_;
  KeySet keys_;
  TrialKeys trials_;
};

}  // namespace

std::vector<std::size_t> missed_keys(const std::vector<std::size_t>& removed, const std::vector<WorstSample>& worst) {
  std::vector<std::size_t> found;
  std::size_t nearest = 0;  // among the removed
  const auto distance = [&](std::size_t m, std::size_t segment) {
    const std::size_t merged = merged_segment(removed, m);
    return std::max(merged, segment) - std::min(merged, segment);
  };
  for (std::size_t s = 0; s < worst.size(); ++s) {
    while (nearest + 1 < removed.size() && distance(nearest + 1, s) < distance(nearest, s)) ++nearest;
    if (worst[s].excess > 1.0 && (found.empty() || found.back() != removed[nearest])) found.push_back(removed[nearest]);
  }
  return found;
}

Expected<KeySet> with_keys_removed(const LocalMethod& method, const ToleranceCheck& recording, KeySet keys,
                                   const Repair& repair) {
  return Removal(method, recording, repair, std::move(keys)).run();
}

}}  // namespace orispline
