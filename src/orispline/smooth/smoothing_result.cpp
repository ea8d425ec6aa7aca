// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_result.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t motion_run = 3;            // of rejected samples; the loss tukey may have it
constexpr double many = 0.01;                    // as a share of the samples
constexpr double contradiction = 1.2;            // of a stated noise
constexpr double jump = 0.5 * std::numbers::pi;  // [rad] from sample to sample
constexpr double wanted_step = 1e-6;             // [rad] of the last step of the iteration

double cutoff_of(double smoothing_time) { return 1.0 / (2.0 * std::numbers::pi * smoothing_time); }

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

using SampleIndices = std::vector<std::size_t>;

/// `distance(key, sample)` over all keys but those of the rising samples that are left out.
template <class Distance>
SampleDistances distances_by(const SampleIndices& keys, const SampleIndices& left_out, Distance distance) {
  SampleDistances distances;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t key = 0; key < keys.size(); ++key) {
    if (std::ranges::binary_search(left_out, keys[key])) continue;
    const double length = distance(key, keys[key]);
    sum += length * length;
    distances.largest = std::max(distances.largest, length);
    ++count;
  }
  if (count > 0) distances.rms = std::sqrt(sum / static_cast<double>(count));
  return distances;
}

Warning rejected_run(const SampleRun& run) {
  return {.code = "rejected_run",
          .message = formatted("{} samples in a row do not count, which is rather motion than outliers: wanted `loss` "
                               "robust, which keeps them",
                               run.second),
          .where = {.key = run.first},
          .numbers = {{"samples", static_cast<double>(run.second)}}};
}

/// `what`: samples or positions.
Warning many_rejected(std::string_view code, std::string_view what, std::size_t rejected, std::size_t all) {
  const double share = 100.0 * static_cast<double>(rejected) / static_cast<double>(all);
  return {.code = code,
          .message = formatted("{} of {} {} ({:.2g} %) are rejected as outliers; if they are motion, set `loss` to l2, "
                               "which keeps every sample",
                               rejected, all, what, share),
          .numbers = {{"samples", static_cast<double>(rejected)}}};
}

/// Where single samples are rejected in such numbers, some come side by side, and count as motion.
Warning outliers_followed(const std::vector<std::size_t>& retained, std::size_t rejected) {
  return {
      .code = "outliers_followed",
      .message = formatted("{} as far as the {} that are rejected {} followed as motion; if they are faults too, as "
                           "where a tag flips now and then, set `loss` to huber",
                           counted(retained.size(), "sample"), rejected, retained.size() == 1 ? "is" : "are"),
      .where = {.key = retained.front()},
      .numbers = {{"samples", static_cast<double>(retained.size())}}};
}

Warning jumps_followed_at(std::size_t first, std::size_t count) {
  return {.code = "jumps_followed",
          .message = formatted("{} turn{} by more than 90° from the one before and {} followed as motion; if they are "
                               "faults, as where markers were swapped, set `loss` to huber",
                               counted(count, "sample"), count == 1 ? "s" : "", count == 1 ? "is" : "are"),
          .where = {.key = first},
          .numbers = {{"samples", static_cast<double>(count)}}};
}

constexpr double far_mount = 20.0;  // [°]: what no sensor that was put on with care is off by

/// Over all axes.
double root_mean_square(const std::vector<Eigen::Vector3d>& vectors) {
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / (3.0 * static_cast<double>(vectors.size())));
}

/// `x and z`
std::string axes_text(const std::array<bool, 3>& axes) {
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axes[axis]) text += formatted("{}{}", text.empty() ? "" : " and ", "xyz"[axis]);
  return text;
}

void warn_of_repairs(const GyroFinding& gyro, std::vector<Warning>& warnings) {
  if (!gyro.clock_jumps.empty()) {
    const auto& [rate, seconds] = gyro.clock_jumps.front();
    warnings.push_back(
        {.code = "gyro_clock_jumps",
         .message = formatted("the clock of the gyro jumps ahead {}, first by {:.4g} s at rate {} of the "
                              "gyro; no rate is missing there, and the stamps behind it were set back",
                              counted(gyro.clock_jumps.size(), "time"), seconds, rate),
         .numbers = {{"jump_s", seconds}}});
  }
  if (gyro.came_in_batches)
    warnings.push_back({.code = "gyro_in_batches",
                        .message = "the stamps of the gyro come in batches; the rates of each batch were spread evenly "
                                   "over the time since the one before"});
  if (const double angle = gyro.mount ? gyro.mount->value.norm() * degrees : 0.0; angle > far_mount)
    warnings.push_back(
        {.code = "gyro_turned",
         .message = formatted("the gyro is mounted by {:.3g}° off the axes of the body; its rates were turned", angle),
         .numbers = {{"mount_rad", angle / degrees}}});
  if (const std::string axes = axes_text(gyro.unwound_axes); !axes.empty())
    warnings.push_back({.code = "gyro_unwound",
                        .message = formatted("the rates of the gyro about {} come round like a counter that is too "
                                             "short; whole rounds were added",
                                             axes)});
  if (const std::string axes = axes_text(gyro.dead_axes); !axes.empty())
    warnings.push_back({.code = "gyro_axis_dead",
                        .message = formatted("the rates of the gyro about {} are all the same, though the body turns "
                                             "that way; only its other axes count",
                                             axes)});
}

/// Where a recording with a gyro is too short to tell how large noise is that keeps.
std::optional<Warning> short_for_its_noise(const Smoothing& smoothing) {
  constexpr double long_enough = 20.0;  // in correlation times
  constexpr double factor = 2.0;        // by which the error may else be another, docs/gyro.md
  if (!smoothing.correlated_noise || !smoothing.gyro->risk || smoothing.track.keys.size() == 0) return std::nullopt;
  const auto times = smoothing.track.keys.times();
  const double time = smoothing.correlated_noise->time, seconds = times.back() - times.front(),
               error = smoothing.gyro->risk->with;
  if (seconds >= long_enough * time) return std::nullopt;
  return Warning{.code = "short_for_its_noise",
                 .message = formatted(
                     "the noise of the orientations correlates over {:.2g} s, and the recording is {:.3g} s long: "
                     "the error may be anything from {:.2g}° to {:.2g}°; a recording of {:.2g} s would tell it",
                     time, seconds, error / factor * degrees, error * factor * degrees, long_enough * time),
                 .numbers = {{"least_rad", error / factor}, {"most_rad", error * factor}}};
}

/// Why a gyro was left out, and the cure.
const char* reason_of(GyroFinding::Doubt doubt) {
  switch (doubt) {
    case GyroFinding::Doubt::reach:
      return "fewer than half of the orientations stand between its rates; look at its stamps, which may come in "
             "batches or from another clock";
    case GyroFinding::Doubt::clock:
      return "its clock jumps or wanders against that of the orientations; cut the recording where it jumps, or repair "
             "the stamps";
    case GyroFinding::Doubt::rates:
      return "no scale, mount, bias or clock that was tried brings its rates to the orientations, as where an axis is "
             "dead, rates are stuck or counters come round, or where they are those of another body; set `noise` if "
             "the orientations are less exact than they seem";
    default:
      return "the orientations are hardly better known with it; set `noise` if they are less exact than they seem";
  }
}

Warning gyro_left_out(const GyroFinding& gyro) {
  const double with = gyro.risk->with, without = gyro.risk->without;
  return {
      .code = "gyro_left_out",
      .message = formatted("the gyro was left out, and the orientations are expected to be {:.3g}° off without it: {}",
                           without * degrees, reason_of(gyro.doubt)),
      .numbers = {{"with_rad", with}, {"without_rad", without}}};
}

bool contradicts(double found, double stated) {
  return found > contradiction * stated || found * contradiction < stated;
}

Warning noise_contradicted(double found, double stated) {
  return {.code = "noise_contradicted",
          .message =
              formatted("the orientations are {:.3g}° per axis off the motion that the gyro agrees with, and `noise` "
                        "states {:.3g}°: it may be another, the clock or the bias of the gyro may change, or the "
                        "orientations were filtered, so that their noise is not white",
                        found * degrees, stated * degrees),
          .numbers = {{"found_rad", found}, {"stated_rad", stated}}};
}

bool are_many(std::size_t rejected, std::size_t all) {
  return static_cast<double>(rejected) > many * static_cast<double>(all);
}

}  // namespace

std::optional<Warning> jumps_followed(const Smoothing& smoothing, const Keyframes& recording) {
  const auto q = recording.orientations();
  std::optional<std::size_t> first;
  std::size_t count = 0;
  for (const std::size_t i : smoothing.retained_outlier_runs) {
    if (i == 0 || angular_distance(q[i - 1], q[i]) <= jump) continue;
    if (!first) first = i;
    ++count;
  }
  return first ? std::optional(jumps_followed_at(*first, count)) : std::nullopt;
}

std::optional<double> PositionSmoothing::cutoff() const noexcept {
  return smoothing_time ? std::optional(cutoff_of(*smoothing_time)) : std::nullopt;
}

double Smoothing::cutoff() const noexcept { return cutoff_of(smoothing_time); }

std::optional<double> Smoothing::shortest_smoothing_time() const {
  return smoothing_times.empty() ? std::nullopt : std::optional(std::ranges::min(smoothing_times));
}

std::optional<double> Smoothing::longest_smoothing_time() const {
  return smoothing_times.empty() ? std::nullopt : std::optional(std::ranges::max(smoothing_times));
}

std::optional<double> Smoothing::least_noise_of_samples() const {
  return noises.empty() ? std::nullopt : std::optional(std::ranges::min(noises));
}

std::optional<double> Smoothing::largest_noise_of_samples() const {
  return noises.empty() ? std::nullopt : std::optional(std::ranges::max(noises));
}

std::optional<double> Smoothing::rms_sigma() const {
  return sigmas ? std::optional(root_mean_square(sigmas->orientations)) : std::nullopt;
}

std::optional<double> Smoothing::rms_sigma_of_rates() const {
  return sigmas ? std::optional(root_mean_square(sigmas->angular_velocities)) : std::nullopt;
}

bool Smoothing::covers(double t) const {
  const auto times = track.keys.times();
  const auto behind = std::ranges::upper_bound(times, t);
  if (behind == times.begin()) return false;
  if (!places.empty()) return t <= times.back();  // with a gyro there is one stretch
  const auto before = behind - 1;                 // the key
  const std::size_t sample = keys[static_cast<std::size_t>(before - times.begin())];
  const auto next_stretch = std::ranges::upper_bound(stretches, sample, {}, &Stretch::first);
  const auto& [first, count] = *(next_stretch - 1);
  return *before == t || sample + 1 < first + count;
}

SampleDistances distances_of(const Smoothing& smoothing, const Keyframes& recording, CountedSamples which) {
  return distances_by(smoothing.keys, which == CountedSamples::all ? SampleIndices() : smoothing.rejected,
                      [&](std::size_t key, std::size_t sample) {
                        return angular_distance(smoothing.nodes.orientations[smoothing.place_of(key)],
                                                recording.orientations()[sample]);
                      });
}

SampleDistances position_distances_of(const Smoothing& smoothing, const Keyframes& recording, CountedSamples which) {
  return distances_by(
      smoothing.keys, which == CountedSamples::all ? SampleIndices() : smoothing.positions->rejected,
      [&](std::size_t key, std::size_t sample) {
        return (smoothing.nodes.positions[smoothing.place_of(key)] - recording.positions()[sample]).norm();
      });
}

std::vector<Warning> warnings_of(const Smoothing& smoothing, const SmoothOptions& options) {
  std::vector<Warning> warnings;
  const std::size_t all = smoothing.keys.size(), rejected = smoothing.rejected.size();
  const bool rejects_many = are_many(rejected, all);
  if (const auto& retained = smoothing.retained_outlier_runs; rejects_many && !retained.empty())
    warnings.push_back(outliers_followed(retained, rejected));
  if (smoothing.edge == LambdaChoice::Edge::shortest)
    warnings.push_back({.code = "least_smoothing",
                        .message =
                            "the least smoothing was taken, because hardly any noise was found beside the motion "
                            "or because `noise` is too small; set `smoothing_time` for more or less"});
  if (smoothing.edge == LambdaChoice::Edge::longest)
    warnings.push_back({.code = "most_smoothing",
                        .message = "no change of the rates was found beside the noise: the most smoothing was taken; "
                                   "set `smoothing_time` to have less"});
  if (const SampleRun run = longest_rejected_run(smoothing); run.second >= motion_run)
    warnings.push_back(rejected_run(run));
  if (smoothing.gyro && smoothing.gyro->used) warn_of_repairs(*smoothing.gyro, warnings);
  if (smoothing.gyro && smoothing.gyro->used)
    if (auto warning = short_for_its_noise(smoothing)) warnings.push_back(std::move(*warning));
  if (smoothing.gyro && !smoothing.gyro->used) warnings.push_back(gyro_left_out(*smoothing.gyro));
  if (smoothing.gyro && smoothing.gyro->used && options.noise && contradicts(smoothing.noise, *options.noise))
    warnings.push_back(noise_contradicted(smoothing.noise, *options.noise));
  if (rejects_many) warnings.push_back(many_rejected("many_rejected", "samples", rejected, all));
  if (const auto& positions = smoothing.positions; positions && are_many(positions->rejected.size(), all))
    warnings.push_back(many_rejected("many_positions_rejected", "positions", positions->rejected.size(), all));
  if (smoothing.last_step > wanted_step)
    warnings.push_back(
        {.code = "unfinished",
         .message = formatted("the last step of the iteration still moved by {:.2g} rad", smoothing.last_step),
         .numbers = {{"step_rad", smoothing.last_step}}});
  return warnings;
}

}}  // namespace orispline
