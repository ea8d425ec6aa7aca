// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_result.hpp>

#include <algorithm>
#include <numbers>

namespace orispline {
namespace {

constexpr std::size_t motion_run = 3;  // of rejected samples; the loss tukey may have it
constexpr double wanted_step = 1e-6;   // [rad] of the last step of the iteration

/// The longest run of rejected samples in one stretch, of equals the first; none of length 0.
SmoothingWarning longest_rejected_run(const Smoothing& smoothing) {
  SmoothingWarning longest{.code = SmoothingWarning::Code::rejected_run};
  std::size_t run = 0;
  for (std::size_t k = 0; k < smoothing.rejected.size(); ++k) {
    const std::size_t sample = smoothing.rejected[k];
    const bool follows = k > 0 && smoothing.rejected[k - 1] + 1 == sample &&
                         !std::ranges::binary_search(smoothing.stretches, sample, {}, &Stretch::first);
    run = follows ? run + 1 : 1;
    if (run <= longest.count) continue;
    longest.count = run;
    longest.sample = sample + 1 - run;
  }
  return longest;
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

std::vector<SmoothingWarning> warnings_of(const Smoothing& smoothing) {
  using Code = SmoothingWarning::Code;
  std::vector<SmoothingWarning> warnings;
  if (smoothing.edge == LambdaChoice::Edge::shortest) warnings.push_back({.code = Code::least_smoothing});
  if (smoothing.edge == LambdaChoice::Edge::longest) warnings.push_back({.code = Code::most_smoothing});
  if (const SmoothingWarning run = longest_rejected_run(smoothing); run.count >= motion_run) warnings.push_back(run);
  if (smoothing.last_step > wanted_step) warnings.push_back({.code = Code::unfinished, .step = smoothing.last_step});
  return warnings;
}

}  // namespace orispline
