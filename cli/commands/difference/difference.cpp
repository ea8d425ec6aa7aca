// SPDX-License-Identifier: Apache-2.0
#include "commands/difference/difference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/reduce/clip_reduction_fields.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "commands/difference/difference_report.hpp"
#include "options/option_text.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {
namespace {

constexpr double most_times = 1e8;

/// A clip of the first file, and what the second one calls the same.
struct ClipPair {
  const Clip *first, *second;
};

std::vector<ClipPair> pairs_of(const scenes::Scene& first, const scenes::Scene& second, DifferenceReport& report) {
  if (first.clips.size() == 1 && second.clips.size() == 1) return {{&first.clips[0], &second.clips[0]}};
  std::vector<ClipPair> pairs;
  std::vector<bool> taken(second.clips.size());
  for (const Clip& clip : first.clips) {
    std::size_t i = 0;
    while (i < taken.size() && (taken[i] || second.clips[i].name != clip.name)) ++i;
    if (i == taken.size()) {
      report.only_in_first.push_back(clip.name);
      continue;
    }
    taken[i] = true;
    pairs.push_back({&clip, &second.clips[i]});
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i]) report.only_in_second.push_back(second.clips[i].name);
  return pairs;
}

/// The key times of a clip, and those of the rate between them.
Expected<std::vector<double>> times_of(const Clip& clip, std::optional<double> rate) {
  std::vector<double> times = key_times(clip);
  if (times.empty()) times.push_back(0.0);
  if (!rate) return times;
  const double start = times.front(), span = times.back() - start;
  if (span * *rate > most_times)
    return usage_failure(
        formatted("--rate: found {:g} times in the clip, wanted {:g} at most", span * *rate, most_times));
  for (std::size_t i = 0; static_cast<double>(i) <= span * *rate; ++i)
    times.push_back(start + static_cast<double>(i) / *rate);
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

Expected<ClipDifference> compared(const scenes::Scene& first, const scenes::Scene& second, const ClipPair& pair,
                                  const DifferenceReport& report, std::optional<double> rate) {
  const auto times = times_of(*pair.first, rate);
  if (!times) return tl::unexpected(times.error());
  const auto counterparts = counterparts_of(first.skeleton, second.skeleton);
  const auto found = differences(ClipMotion(first.skeleton, *pair.first), ClipMotion(second.skeleton, *pair.second),
                                 counterparts, *times, report.shell);
  ClipDifference result{.clip = pair.first->name, .times = times->size()};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (counterparts[i] == no_parent) continue;
    result.joints.push_back(first.skeleton[i].name);
    result.worst.push_back(found[i]);
  }
  return result;
}

Expected<scenes::Scene> opened(const std::string& path) {
  return scenes::read_scene(path).map([](scenes::Scene scene) {
    warn(scene.warnings);
    return scene;
  });
}

/// The chosen clips. The only clip of a file is the one that is compared, whatever its name.
Expected<scenes::Scene> with_chosen(scenes::Scene scene, const std::vector<std::string>& clips) {
  if (scene.clips.size() == 1 && clips.size() == 1) return scene;
  return scenes::with_clips(std::move(scene), clips);
}

}  // namespace

Expected<void> difference(const DifferenceOptions& options) {
  FirstError checked;
  const double shell = checked(options_in<orispline::ClipReduceOptions>(options.shell)).shell;
  const auto rate = checked(if_given("--rate", options.rate, [](OptionText text) { return positive_in(text); }));
  const auto open = [&](const std::string& path) {
    return opened(path).and_then([&](scenes::Scene scene) { return with_chosen(std::move(scene), options.clips); });
  };
  const auto first = checked(open(options.first)), second = checked(open(options.second));
  DifferenceReport report{.first = options.first, .second = options.second, .shell = shell};
  if (auto understood = std::move(checked).or_else(true); !understood) return tl::unexpected(understood.error());
  const std::vector<ClipPair> pairs = pairs_of(first, second, report);
  if (pairs.empty())
    return failure(ErrorCode::bad_data, "found no clip of the same name, wanted one at least",
                   {.file = options.second});
  const auto counterparts = counterparts_of(first.skeleton, second.skeleton);
  report.joints_only_in_first = static_cast<std::size_t>(std::ranges::count(counterparts, no_parent));
  std::vector<Expected<ClipDifference>> found(pairs.size());
  parallel_for(pairs.size(), 0, [&](std::size_t i) { found[i] = compared(first, second, pairs[i], report, rate); });
  for (auto& clip : found) {
    if (!clip) return tl::unexpected(std::move(clip.error()));
    report.clips.push_back(*std::move(clip));
  }
  return print_document(options.json ? document(json_of(report)) : text_of(report));
}

}  // namespace orispline::cli
