// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/difference.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr double most_times = 1e8;

/// Clips of one name.
struct Namesakes {
  std::vector<std::size_t> first{}, second{};

  [[nodiscard]] std::size_t pairs() const noexcept { return std::min(first.size(), second.size()); }
};

/// The clips of both files that are the same, of equal names by their order. Their times are not yet known.
std::vector<ClipDifference> paired(DifferenceOutcome& outcome) {
  const auto &first = outcome.request.first.clips, &second = outcome.request.second.clips;
  if (first.size() == 1 && second.size() == 1) return {{0, 0}};
  std::map<std::string_view, Namesakes> names;
  for (std::size_t i = 0; i < first.size(); ++i) names[first[i].name].first.push_back(i);
  for (std::size_t i = 0; i < second.size(); ++i) names[second[i].name].second.push_back(i);
  std::vector<std::size_t> found(first.size(), second.size());
  std::vector<bool> taken(second.size());
  for (const auto& [name, same] : names)
    for (std::size_t k = 0; k < same.pairs(); ++k) {
      found[same.first[k]] = same.second[k];
      taken[same.second[k]] = true;
      if (same.first.size() > 1 || same.second.size() > 1) outcome.guessed_clips.push_back(same.first[k]);
    }
  std::vector<ClipDifference> pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (found[i] == second.size()) outcome.only_in_first.push_back(first[i].name);
    else pairs.push_back({i, found[i]});
  for (std::size_t i = 0; i < second.size(); ++i)
    if (!taken[i]) outcome.only_in_second.push_back(second[i].name);
  std::ranges::sort(outcome.guessed_clips);
  return pairs;
}

Warning guessed(std::string_view code, std::string_view what, std::size_t count, const std::string& such_as) {
  return {.code = code,
          .message = formatted("found {} whose name others have too, such as {}; by their order it was guessed which "
                               "they are in the second file",
                               counted(count, what), in_quotes(such_as)),
          .numbers = {{"count", static_cast<double>(count)}}};
}

std::vector<Warning> warnings_of(const DifferenceOutcome& outcome) {
  std::vector<Warning> warnings;
  const auto &clips = outcome.guessed_clips, &joints = outcome.counterparts.guessed;
  if (!clips.empty())
    warnings.push_back(guessed("clips_guessed", "clip", clips.size(), outcome.request.first.clips[clips.front()].name));
  if (!joints.empty())
    warnings.push_back(guessed("joints_guessed", "joint", joints.size(), outcome.name_of_joint(joints.front())));
  for (Warning& warning : warnings) warning.where.file = outcome.request.first.name;
  return warnings;
}

/// The key times of a clip, and those of the rate between them.
Expected<std::vector<double>> compared_times(const Clip& clip, std::optional<double> rate) {
  std::vector<double> times = key_times(clip);
  if (times.empty()) times.push_back(0.0);
  if (!rate) return times;
  const double start = times.front(), span = times.back() - start;
  if (span * *rate > most_times)
    return bad_option("rate", formatted("found {:g} times in the clip, wanted {:g} at most", span * *rate, most_times));
  for (std::size_t i = 0; static_cast<double>(i) <= span * *rate; ++i)
    times.push_back(start + static_cast<double>(i) / *rate);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

void compare_joints(ClipDifference& clip, const DifferenceRequest& request, std::span<const std::size_t> counterparts) {
  const MotionFile &first = request.first, &second = request.second;
  const auto found = differences(ClipMotion(first.skeleton, first.clips[clip.first]),
                                 ClipMotion(second.skeleton, second.clips[clip.second]), counterparts, clip.times,
                                 request.shell, request.rate ? Between::looked_at : Between::nothing);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (counterparts[i] == no_parent) continue;
    clip.joints.push_back(i);
    clip.worst.push_back(found[i]);
  }
}

}  // namespace

const std::string& DifferenceOutcome::name_of(const ClipDifference& clip) const {
  return request.first.clips[clip.first].name;
}

std::string DifferenceOutcome::name_of_joint(std::size_t joint) const {
  return request.first.skeleton.shown_name(joint);
}

Expected<DifferenceOutcome> difference(DifferenceRequest request) {
  DifferenceOutcome outcome{.request = std::move(request)};
  const auto& [first, second, shell, rate, threads] = outcome.request;
  outcome.clips = paired(outcome);
  if (outcome.clips.empty())
    return failure(ErrorCode::bad_data, "found no clip of the same name, wanted one at least", {.file = second.name});
  outcome.counterparts = counterparts_of(first.skeleton, second.skeleton);
  outcome.warnings = warnings_of(outcome);
  for (ClipDifference& clip : outcome.clips) {
    auto times = compared_times(first.clips[clip.first], rate);
    if (!times) return tl::unexpected(std::move(times.error()));
    clip.times = *std::move(times);
  }
  parallel_for(outcome.clips.size(), threads,
               [&](std::size_t i) { compare_joints(outcome.clips[i], outcome.request, outcome.counterparts.joints); });
  return outcome;
}

}}}  // namespace orispline::jobs
