// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_bytes.hpp>

#include <functional>
#include <map>
#include <vector>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The channels of a clip that have the same times, before they had fewer keys.
struct SharedTimes {
  bool stay = false;            ///< in the clip after, for one of the channels has them still
  std::size_t bytes_saved = 0;  ///< where the channels of `go_back` are as they were, but for the times
  std::vector<std::function<void()>> go_back{};
};

}  // namespace

std::size_t bytes_of_keys(const Clip& clip, KeyCompression compression) {
  std::map<std::vector<double>, bool> times;
  std::size_t bytes = 0;
  const auto add = [&](const auto& channels) {
    for (const auto& channel : channels) {
      bytes += bytes_of_values(channel, compression);
      if (times.try_emplace(channel.times, true).second) bytes += bytes_of_times(channel.times, compression);
    }
  };
  add(clip.rotations), add(clip.translations), add(clip.scales);
  return bytes;
}

Clip with_shared_times(const Clip& before, Clip after) {
  std::map<std::vector<double>, SharedTimes> groups;
  const auto gather = [&](const auto& channels, auto& fewer) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      SharedTimes& group = groups[channels[i].times];
      group.stay = group.stay || fewer[i].size() == channels[i].size();
      const std::size_t as_before = bytes_of_values(channels[i]), now = bytes_of_keys(fewer[i]);
      if (as_before >= now) continue;
      group.bytes_saved += now - as_before;
      group.go_back.emplace_back([&channel = channels[i], &place = fewer[i]] { place = channel; });
    }
  };
  gather(before.rotations, after.rotations);
  gather(before.translations, after.translations);
  gather(before.scales, after.scales);
  for (const auto& [times, group] : groups)
    if (group.stay || group.bytes_saved > bytes_of_times(times))
      for (const auto& go_back : group.go_back) go_back();
  return after;
}

}}  // namespace orispline
