// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/key_refit.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/geodesic.hpp>
#include <orispline/optimise/trial_keys.hpp>

namespace orispline::optimise {
namespace {

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
void move(const Recording& recording, const std::vector<Miss>& misses, Range range, KeySet& keys) {
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

class Refit {
 public:
  Refit(const LocalMethod& method, const Recording& recording, KeySet keys)
      : method_(method), recording_(recording), keys_(std::move(keys)), trials_(keys_.size(), apart()) {}

  Expected<KeySet> run() && {
    for (auto tried = trials_.next(); !tried.empty(); tried = trials_.next()) {
      const auto done = attempt(std::move(tried));
      if (!done) return tl::unexpected(done.error());
    }
    return std::move(keys_);
  }

 private:
  [[nodiscard]] std::size_t apart() const { return 2 * (keys_moved + method_.reach) + 1; }

  /// Takes out those of the keys without which it can be done.
  Expected<void> attempt(std::vector<std::size_t> tried) {
    KeySet trial = without(keys_, tried);
    for (std::size_t round = 0; round < rounds; ++round) {
      const auto misses = recording_.misses(method_.name, trial);
      if (!misses) return tl::unexpected(misses.error());
      const auto broken = missed_keys(tried, worst_of_segments(trial, *misses));
      if (broken.empty()) break;
      for (std::size_t m = 0; m < tried.size(); ++m)
        if (std::ranges::binary_search(broken, tried[m]))
          move(recording_, *misses, around(merged_segment(tried, m), keys_moved, trial.size()), trial);
    }
    return settle(std::move(tried), std::move(trial));
  }

  /// Keeps what holds and gives back the other keys where they were, with their neighbours.
  Expected<void> settle(std::vector<std::size_t> tried, KeySet trial) {
    while (!tried.empty()) {
      const auto misses = recording_.misses(method_.name, trial);
      if (!misses) return tl::unexpected(misses.error());
      const auto broken = missed_keys(tried, worst_of_segments(trial, *misses));
      if (broken.empty()) break;
      std::vector<std::size_t> rest;
      KeySet next = keys_;
      for (std::size_t m = 0; m < tried.size(); ++m) {
        if (std::ranges::binary_search(broken, tried[m])) {
          trials_.keep(tried[m]);
          continue;
        }
        rest.push_back(tried[m]);
        take(trial, around(merged_segment(tried, m), keys_moved, trial.size()), m, next);
      }
      tried = std::move(rest);
      trial = without(next, tried);
    }
    if (tried.empty()) return {};
    keys_ = std::move(trial);
    trials_.remove(tried);
    return {};
  }

  /// The values of a range of the trial's keys, before which m keys are missing and in which one is.
  static void take(const KeySet& trial, Range range, std::size_t m, KeySet& keys) {
    for (std::size_t k = range.first; k < range.end; ++k) {
      std::size_t full = k + m;
      if (keys.samples[full] != trial.samples[k]) ++full;
      keys.orientations[full] = trial.orientations[k];
      if (!keys.positions.empty()) keys.positions[full] = trial.positions[k];
    }
  }

  LocalMethod method_;
  const Recording& recording_;
  KeySet keys_;
  TrialKeys trials_;
};

}  // namespace

Expected<KeySet> with_keys_refitted(const LocalMethod& method, const Recording& recording, KeySet keys) {
  return Refit(method, recording, std::move(keys)).run();
}

}  // namespace orispline::optimise
