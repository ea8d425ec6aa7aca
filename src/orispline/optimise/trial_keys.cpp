// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/trial_keys.hpp>

#include <algorithm>

namespace orispline::optimise {

std::vector<std::size_t> TrialKeys::next() const {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 1; i + 1 < open_.size(); ++i)
    if (open_[i] && (chosen.empty() || i - chosen.back() >= apart_)) chosen.push_back(i);
  return chosen;
}

void TrialKeys::remove(const std::vector<std::size_t>& removed) {
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

KeySet without(const KeySet& keys, const std::vector<std::size_t>& removed) {
  KeySet rest{.samples = {}, .orientations = {}};
  auto gone = removed.begin();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (gone != removed.end() && *gone == i) {
      ++gone;
      continue;
    }
    rest.samples.push_back(keys.samples[i]);
    rest.orientations.push_back(keys.orientations[i]);
    if (!keys.positions.empty()) rest.positions.push_back(keys.positions[i]);
  }
  return rest;
}

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

}  // namespace orispline::optimise
