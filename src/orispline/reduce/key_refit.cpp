// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/key_refit.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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

Expected<KeySet> with_keys_refitted(const LocalMethod& method, const ToleranceCheck& recording, KeySet keys) {
  const auto apply = [&](const std::vector<std::size_t>& removed, KeySet& rest) {
    return refit(method, recording, removed, rest);
  };
  return with_keys_removed(method, recording, std::move(keys), {.keys_moved = keys_moved, .apply = apply});
}

}}  // namespace orispline
