// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/difference.hpp>

#include <algorithm>
#include <span>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr double most_times = 1e8;

/// The clips of both files that are the same. Their times are not yet known.
std::vector<ClipDifference> paired(DifferenceOutcome& outcome) {
  const auto &first = outcome.request.first.clips, &second = outcome.request.second.clips;
  if (first.size() == 1 && second.size() == 1) return {{0, 0}};
  std::vector<ClipDifference> pairs;
  std::vector<bool> taken(second.size());
  for (std::size_t clip = 0; clip < first.size(); ++clip) {
    std::size_t i = 0;
    while (i < taken.size() && (taken[i] || second[i].name != first[clip].name)) ++i;
    if (i == taken.size()) {
      outcome.only_in_first.push_back(first[clip].name);
      continue;
    }
    taken[i] = true;
    pairs.push_back({clip, i});
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (!taken[i]) outcome.only_in_second.push_back(second[i].name);
  return pairs;
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
  const auto found =
      differences(ClipMotion(first.skeleton, first.clips[clip.first]),
                  ClipMotion(second.skeleton, second.clips[clip.second]), counterparts, clip.times, request.shell);
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

const std::string& DifferenceOutcome::name_of_joint(std::size_t joint) const {
  return request.first.skeleton[joint].name;
}

Expected<DifferenceOutcome> difference(DifferenceRequest request) {
  DifferenceOutcome outcome{.request = std::move(request)};
  const auto& [first, second, shell, rate, threads] = outcome.request;
  outcome.clips = paired(outcome);
  if (outcome.clips.empty())
    return failure(ErrorCode::bad_data, "found no clip of the same name, wanted one at least", {.file = second.name});
  const auto counterparts = counterparts_of(first.skeleton, second.skeleton);
  outcome.joints_only_in_first = static_cast<std::size_t>(std::ranges::count(counterparts, no_parent));
  for (ClipDifference& clip : outcome.clips) {
    auto times = compared_times(first.clips[clip.first], rate);
    if (!times) return tl::unexpected(std::move(times.error()));
    clip.times = *std::move(times);
  }
  parallel_for(outcome.clips.size(), threads,
               [&](std::size_t i) { compare_joints(outcome.clips[i], outcome.request, counterparts); });
  return outcome;
}

}}}  // namespace orispline::jobs
