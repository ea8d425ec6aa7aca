// SPDX-License-Identifier: Apache-2.0
#include "commands/difference/difference.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/reduce/reduce_fields.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "commands/difference/difference_report.hpp"
#include "options/option_text.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

constexpr double most_times = 1e8;

/// The clips of both files that have the same name. Their times are not yet known.
std::vector<pages::ClipPair> pairs_of(const scenes::Scene& first, const scenes::Scene& second,
                                      DifferenceReport& report) {
  if (first.clips.size() == 1 && second.clips.size() == 1) return {{0, 0}};
  std::vector<pages::ClipPair> pairs;
  std::vector<bool> taken(second.clips.size());
  for (std::size_t clip = 0; clip < first.clips.size(); ++clip) {
    const std::string& name = first.clips[clip].name;
    std::size_t i = 0;
    while (i < taken.size() && (taken[i] || second.clips[i].name != name)) ++i;
    if (i == taken.size()) {
      report.only_in_first.push_back(name);
      continue;
    }
    taken[i] = true;
    pairs.push_back({clip, i});
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

ClipDifference compared(const scenes::Scene& first, const scenes::Scene& second, const pages::ClipPair& pair,
                        std::span<const std::size_t> counterparts, double shell) {
  const Clip& clip = first.clips[pair.before];
  const auto found =
      differences(ClipMotion(first.skeleton, clip), ClipMotion(second.skeleton, second.clips[pair.after]), counterparts,
                  pair.times, shell);
  ClipDifference result{.clip = clip.name, .times = pair.times.size()};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (counterparts[i] == no_parent) continue;
    result.joints.push_back(first.skeleton[i].name);
    result.worst.push_back(found[i]);
  }
  return result;
}

/// Fills the report.
Expected<std::vector<pages::ClipPair>> compare_clips(const scenes::Scene& first, const scenes::Scene& second,
                                                     std::optional<double> rate, DifferenceReport& report) {
  std::vector<pages::ClipPair> pairs = pairs_of(first, second, report);
  if (pairs.empty())
    return failure(ErrorCode::bad_data, "found no clip of the same name, wanted one at least", {.file = report.second});
  const auto counterparts = counterparts_of(first.skeleton, second.skeleton);
  report.joints_only_in_first = static_cast<std::size_t>(std::ranges::count(counterparts, no_parent));
  for (pages::ClipPair& pair : pairs) {
    auto times = times_of(first.clips[pair.before], rate);
    if (!times) return tl::unexpected(std::move(times.error()));
    pair.times = *std::move(times);
  }
  report.clips.resize(pairs.size());
  parallel_for(pairs.size(), 0,
               [&](std::size_t i) { report.clips[i] = compared(first, second, pairs[i], counterparts, report.shell); });
  return pairs;
}

std::vector<std::string> notes_on(const DifferenceReport& report, std::optional<double> rate) {
  std::vector<std::string> notes{formatted("Both motions are compared at every key of {}{}.",
                                           file_name_of(report.first),
                                           rate ? formatted(", and {:g} times per second as well", *rate) : "")};
  for (const auto& [file, clips] :
       {std::pair{&report.first, &report.only_in_first}, {&report.second, &report.only_in_second}})
    if (!clips->empty())
      notes.push_back(formatted("Only {} has {}, such as {}; not compared.", file_name_of(*file),
                                counted(clips->size(), "more clip"), in_quotes(clips->front())));
  return notes;
}

Expected<scenes::Scene> opened(const std::string& path) {
  return scenes::read_scene(path).map([](scenes::Scene scene) {
    warn(scene.warnings);
    return scene;
  });
}

/// The chosen clips. The only clip of both files is the one that is compared, whatever its name in the second.
Expected<scenes::Scene> with_chosen(scenes::Scene scene, const std::vector<std::string>& clips, bool is_second) {
  if (is_second && scene.clips.size() == 1 && clips.size() == 1) return scene;
  return scenes::with_clips(std::move(scene), clips);
}

}  // namespace

Expected<void> difference(const DifferenceOptions& options) {
  if (auto apart = check_report(options.report, {{"FIRST", options.first}, {"SECOND", options.second}}); !apart)
    return apart;
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  FirstError checked;
  const double shell = checked(options_in<orispline::ClipReduceOptions>(options.shell)).shell;
  const auto rate = checked(if_given("--rate", options.rate, [](OptionText text) { return positive_in(text); }));
  const auto open = [&](const std::string& path, bool is_second) {
    return opened(path).and_then(
        [&](scenes::Scene scene) { return with_chosen(std::move(scene), options.clips, is_second); });
  };
  const auto first = checked(open(options.first, false)), second = checked(open(options.second, true));
  DifferenceReport report{.first = options.first, .second = options.second, .shell = shell};
  if (auto understood = std::move(checked).or_else(true); !understood) return tl::unexpected(understood.error());
  const auto pairs = compare_clips(first, second, rate, report);
  if (!pairs) return tl::unexpected(pairs.error());
  const auto make_page = [&](auto head) {
    head.notes = notes_on(report, rate);
    return pages::skeleton_page(
        {report.first, first.skeleton, first.clips}, {report.second, second.skeleton, second.clips}, *pairs,
        {.are_known = !first.format->has_no_unit && !second.format->has_no_unit, .shell = shell}, head);
  };
  return page->write(make_page)
      .and_then([&] { return print_document(options.json ? document(json_of(report)) : text_of(report)); })
      .and_then([&] { return page->finish(); });
}

}  // namespace orispline::cli
