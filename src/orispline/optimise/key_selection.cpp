// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/key_selection.hpp>

#include <algorithm>

#include <orispline/optimise/trial_keys.hpp>

namespace orispline::optimise {

Expected<KeySet> with_keys_added(const LocalMethod& method, const Recording& recording, KeySet keys) {
  for (;;) {
    const auto worst = recording.worst_samples(method.name, keys);
    if (!worst) return tl::unexpected(worst.error());
    std::vector<std::size_t> samples;
    for (std::size_t s = 0; s < worst->size(); ++s) {
      samples.push_back(keys.samples[s]);
      if ((*worst)[s].excess > 1.0) samples.push_back((*worst)[s].sample);
    }
    samples.push_back(keys.samples.back());
    if (samples.size() == keys.size()) return keys;
    keys = recording.keys_at(std::move(samples));
  }
}

Expected<KeySet> with_keys_pruned(const LocalMethod& method, const Recording& recording, KeySet keys) {
  TrialKeys trials(keys.size(), 2 * method.reach + 1);
  for (std::vector<std::size_t> tried = trials.next(); !tried.empty(); tried = trials.next()) {
    while (!tried.empty()) {
      const auto worst = recording.worst_samples(method.name, without(keys, tried));
      if (!worst) return tl::unexpected(worst.error());
      const std::vector<std::size_t> needed = missed_keys(tried, *worst);
      if (needed.empty()) break;
      for (const std::size_t key : needed) trials.keep(key);
      std::erase_if(tried, [&](std::size_t key) { return std::ranges::binary_search(needed, key); });
    }
    keys = without(keys, tried);
    trials.remove(tried);
  }
  return keys;
}

}  // namespace orispline::optimise
