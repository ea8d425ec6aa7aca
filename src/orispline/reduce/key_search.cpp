// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/key_search.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/math/geodesic.hpp>

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

Expected<KeySet> with_keys_added(const LocalMethod& method, const ToleranceCheck& recording, KeySet keys) {
  for (;;) {
    const auto worst = recording.worst_samples(method.method, keys);
    if (!worst) return tl::unexpected(worst.error());
    std::vector<std::size_t> samples;
    for (std::size_t s = 0; s < worst->size(); ++s) {
      samples.push_back(keys.samples[s]);
      const std::size_t found = (*worst)[s].sample;
      if ((*worst)[s].excess > 1.0 && keys.samples[s] < found && found < keys.samples[s + 1]) samples.push_back(found);
    }
    samples.push_back(keys.samples.back());
    if (samples.size() == keys.size()) return keys;
    keys = recording.keys_at(std::move(samples));
  }
}

/// By which shares of the gap that a removed key leaves its two neighbours move inwards.
struct Shares {
  double before, after;
};
constexpr std::array exchanges{Shares{0.25, 0.0}, Shares{0.0, 0.25},  Shares{0.125, 0.125}, Shares{0.5, 0.0},
                               Shares{0.0, 0.5},  Shares{0.125, 0.0}, Shares{0.0, 0.125},   Shares{0.25, 0.25}};

Repair exchange(const ToleranceCheck& recording, Shares shares) {
  const auto apply = [&recording, shares](const std::vector<std::size_t>& removed, KeySet& rest) -> Expected<void> {
    for (std::size_t m = 0; m < removed.size(); ++m) {
      const std::size_t before = merged_segment(removed, m), after = before + 1;
      const auto gap = static_cast<double>(rest.samples[after] - rest.samples[before]);
      const auto part = [gap](double share) { return static_cast<std::size_t>(std::floor(share * gap)); };
      if (before > 0) rest.samples[before] += part(shares.before);
      if (after + 1 < rest.size()) rest.samples[after] -= part(shares.after);
    }
    rest = recording.keys_at(std::move(rest.samples));
    return {};
  };
  return {.keys_moved = 1, .apply = apply};
}

constexpr std::size_t keys_moved = 3;  // on either side of a key that is taken out
constexpr std::size_t rounds = 12;     // of moves before a key is given back
constexpr double least_weight = 0.05;  // of a sample that is met

/// The weighted mean of what a key should move by, in the world frame.
struct Move {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();  ///< [rad], [m]
  double weight = 0.0;

  void add(double more, const Miss& miss) {
    turn += more * miss.turn;
    shift += more * miss.shift;
    weight += more;
  }
};

/// Keys from `first` up to `end`, those that may move after a key was taken out.
struct Range {
  std::size_t first, end;
};

Range around(std::size_t merged, std::size_t on_either_side, std::size_t keys) {
  const std::size_t after = merged + 1;
  return {after - std::min(after, on_either_side), std::min(keys, after + on_either_side)};
}

/// The keys of the range moved by one step.
void move(const ToleranceCheck& recording, const std::vector<Miss>& misses, Range range, KeySet& keys) {
  const auto times = recording.samples().times();
  std::vector<Move> moves(range.end - range.first);
  const auto add = [&](std::size_t key, double hat, const Miss& miss) {
    if (range.first <= key && key < range.end) moves[key - range.first].add(hat * (least_weight + miss.excess), miss);
  };
  const std::size_t first = range.first - std::min<std::size_t>(range.first, 1);
  for (std::size_t s = first; s < std::min(range.end, keys.size() - 1); ++s) {
    const double start = times[keys.samples[s]], duration = times[keys.samples[s + 1]] - start;
    for (std::size_t i = keys.samples[s]; i <= keys.samples[s + 1]; ++i) {
      const double share = (times[i] - start) / duration;
      add(s, 1.0 - share, misses[i]);
      add(s + 1, share, misses[i]);
    }
  }
  for (std::size_t k = range.first; k < range.end; ++k) {
    const Move& m = moves[k - range.first];
    if (!(m.weight > 0.0)) continue;
    keys.orientations[k] = (exp<double>(m.turn / m.weight) * keys.orientations[k]).normalized();
    if (!keys.positions.empty()) keys.positions[k] += m.shift / m.weight;
  }
}

/// Moves the keys around those that were removed until the curve is within the tolerance, or the rounds are over.
Expected<void> refit(const LocalMethod& method, const ToleranceCheck& recording,
                     const std::vector<std::size_t>& removed, KeySet& rest) {
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto misses = recording.misses(method.method, rest);
    if (!misses) return tl::unexpected(misses.error());
    const auto broken = missed_keys(removed, worst_of_segments(rest, *misses));
    if (broken.empty()) break;
    for (std::size_t m = 0; m < removed.size(); ++m)
      if (std::ranges::binary_search(broken, removed[m]))
        move(recording, *misses, around(merged_segment(removed, m), keys_moved, rest.size()), rest);
  }
  return {};
}

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

Expected<KeySet> selected_keys(const LocalMethod& method, const ToleranceCheck& recording) {
  auto keys = with_keys_added(method, recording, recording.keys_at({0, recording.size() - 1}));
  const auto reduce_by = [&](const Repair& repair) {
    keys = keys.and_then([&](KeySet k) { return with_keys_removed(method, recording, std::move(k), repair); });
  };
  reduce_by({});
  for (const Shares& shares : exchanges) reduce_by(exchange(recording, shares));
  return keys;
}

Expected<KeySet> with_keys_refitted(const LocalMethod& method, const ToleranceCheck& recording, KeySet keys) {
  const auto apply = [&](const std::vector<std::size_t>& removed, KeySet& rest) {
    return refit(method, recording, removed, rest);
  };
  return with_keys_removed(method, recording, std::move(keys), {.keys_moved = keys_moved, .apply = apply});
}

}}  // namespace orispline
