// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_result.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr std::size_t motion_run = 3;  // of rejected samples; the loss tukey may have it
constexpr double many = 0.01;          // as a share of the samples
constexpr double wanted_step = 1e-6;   // [rad] of the last step of the iteration

/// The longest run of rejected samples in one stretch, of equals the first; none of length 0.
SampleRun longest_rejected_run(const Smoothing& smoothing) {
  SampleRun longest{};
  std::size_t run = 0;
  for (std::size_t k = 0; k < smoothing.rejected.size(); ++k) {
    const std::size_t sample = smoothing.rejected[k];
    const bool follows = k > 0 && smoothing.rejected[k - 1] + 1 == sample &&
                         !std::ranges::binary_search(smoothing.stretches, sample, {}, &Stretch::first);
    run = follows ? run + 1 : 1;
    if (run > longest.second) longest = {sample + 1 - run, run};
  }
  return longest;
}

Warning rejected_run(const SampleRun& run) {
  return {.code = "rejected_run",
          .message = formatted("{} samples in a row do not count, which is rather motion than outliers: wanted `loss` "
                               "robust, which keeps them",
                               run.second),
          .where = {.key = run.first},
          .numbers = {{"samples", static_cast<double>(run.second)}}};
}

Warning many_rejected(std::size_t rejected, std::size_t all) {
  const double share = 100.0 * static_cast<double>(rejected) / static_cast<double>(all);
  return {.code = "many_rejected",
          .message =
              formatted("{} of {} samples ({:.2g} %) are rejected as outliers; if they are motion, set `loss` to l2, "
                        "which keeps every sample",
                        rejected, all, share),
          .numbers = {{"samples", static_cast<double>(rejected)}}};
}

}  // namespace

double Smoothing::cutoff() const noexcept { return 1.0 / (2.0 * std::numbers::pi * smoothing_time); }

bool Smoothing::covers(double t) const {
  const auto times = track.keys.times();
  const auto behind = std::ranges::upper_bound(times, t);
  if (behind == times.begin()) return false;
  const auto before = behind - 1;  // the key
  const std::size_t sample = keys[static_cast<std::size_t>(before - times.begin())];
  const auto next_stretch = std::ranges::upper_bound(stretches, sample, {}, &Stretch::first);
  const auto& [first, count] = *(next_stretch - 1);
  return *before == t || sample + 1 < first + count;
}

SampleDistances distances_of(const Smoothing& smoothing, const Keyframes& recording, CountedSamples which) {
  SampleDistances distances;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < smoothing.keys.size(); ++k) {
    const std::size_t sample = smoothing.keys[k];
    if (which == CountedSamples::accepted && std::ranges::binary_search(smoothing.rejected, sample)) continue;
    const double distance = angular_distance(smoothing.nodes.orientations[k], recording.orientations()[sample]);
    sum += distance * distance;
    distances.largest = std::max(distances.largest, distance);
    ++count;
  }
  if (count > 0) distances.rms = std::sqrt(sum / static_cast<double>(count));
  return distances;
}

std::vector<Warning> warnings_of(const Smoothing& smoothing) {
  std::vector<Warning> warnings;
  if (smoothing.edge == LambdaChoice::Edge::shortest)
    warnings.push_back({.code = "least_smoothing",
                        .message = "hardly any noise was found beside the motion: the least smoothing was taken; state "
                                   "`smoothing_time` for more or less"});
  if (smoothing.edge == LambdaChoice::Edge::longest)
    warnings.push_back({.code = "most_smoothing",
                        .message = "no change of the rates was found beside the noise: the most smoothing was taken; "
                                   "state `smoothing_time` to have less"});
  if (const SampleRun run = longest_rejected_run(smoothing); run.second >= motion_run)
    warnings.push_back(rejected_run(run));
  if (static_cast<double>(smoothing.rejected.size()) > many * static_cast<double>(smoothing.keys.size()))
    warnings.push_back(many_rejected(smoothing.rejected.size(), smoothing.keys.size()));
  if (smoothing.last_step > wanted_step)
    warnings.push_back(
        {.code = "unfinished",
         .message = formatted("the last step of the iteration still moved by {:.2g} rad", smoothing.last_step),
         .numbers = {{"step_rad", smoothing.last_step}}});
  return warnings;
}

}  // namespace orispline::inline ORISPLINE_ABI
