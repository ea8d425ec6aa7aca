// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/key_selection.hpp>

#include <array>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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

}  // namespace

Expected<KeySet> selected_keys(const LocalMethod& method, const ToleranceCheck& recording) {
  auto keys = with_keys_added(method, recording, recording.keys_at({0, recording.size() - 1}));
  const auto reduce_by = [&](const Repair& repair) {
    keys = keys.and_then([&](KeySet k) { return with_keys_removed(method, recording, std::move(k), repair); });
  };
  reduce_by({});
  for (const Shares& shares : exchanges) reduce_by(exchange(recording, shares));
  return keys;
}

}}  // namespace orispline
