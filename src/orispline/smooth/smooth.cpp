// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/families/recipe.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/smooth/smoothing_check.hpp>
#include <orispline/smooth/smoothing_gyro.hpp>
#include <orispline/smooth/smoothing_positions.hpp>
#include <orispline/smooth/smoothing_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whether the residuals are those of any motion at all.
Expected<void> near_to_samples(double noise) {
  if (!(noise > largest_noise)) return {};
  return failure(ErrorCode::bad_data,
                 formatted("no smooth motion is near to the samples: they are {:.3g}° per axis off the best one",
                           noise * degrees));
}

/// The steps from a recording to its smoothed orientations.
class Smoother {
 public:
  Smoother(const Keyframes& recording, const SmoothOptions& options, const std::vector<Stretch>& stretches,
           OpenEndedWork& work)
      : recording_(recording),
        options_(options),
        scale_(scale_of(recording)),
        stretches_(stretches),
        search_(problems_of(recording, stretches, options.noise.value_or(scale_.noise)), stretches, plan(), work) {}

  [[nodiscard]] Expected<Smoothing> run() {
    if (auto found = search_.run(); !found) return tl::unexpected(std::move(found.error()));
    result_.noise = search_.residual_noise();
    result_.degrees_of_freedom = 3.0 * search_.freedom().trace;
    if (auto near = near_to_samples(noise_to_judge()); !near) return tl::unexpected(std::move(near.error()));
    if (options_.gyro)
      if (auto done = fit_with_gyro(); !done) return tl::unexpected(std::move(done.error()));
    return finished();
  }

 private:
  [[nodiscard]] SearchPlan plan() const {
    return {.penalty = options_.penalty,
            .loss = options_.loss,
            .criterion = options_.noise ? SmoothingCriterion::ubre : SmoothingCriterion::gcv,
            .smoothing_time = options_.smoothing_time,
            .noise = options_.noise.value_or(scale_.noise),
            .interval = scale_.interval,
            .adapt = options_.adapt && !options_.gyro,
            .unit = "°",
            .unit_size = degrees};
  }

  /// Where the samples are followed as they are the residuals tell little.
  [[nodiscard]] double noise_to_judge() const {
    const bool followed = search_.finding().edge == LambdaChoice::Edge::shortest;
    return followed ? std::max(result_.noise, scale_.noise) : result_.noise;
  }

  [[nodiscard]] Expected<void> fit_with_gyro() {
    auto faults = gyro_faults(search_.fits(), recording_, stretches_);
    if (!faults) return tl::unexpected(std::move(faults.error()));
    result_.rejected_gyro = std::move(*faults);
    result_.gyro_noise = options_.gyro_noise.value_or(
        std::max(least_noise, local_noise(recording_.times(), recording_.angular_velocities())));
    result_.degrees_of_freedom.reset();
    return search_.run_with_gyro(recording_, options_.noise.value_or(std::max(least_noise, result_.noise)),
                                 *result_.gyro_noise, result_.rejected_gyro);
  }

  [[nodiscard]] Smoothing finished() {
    const SmoothingSearch::Finding& found = search_.finding();
    result_.rejected = found.rejected;
    result_.retained_outlier_runs = found.retained_outlier_runs;
    result_.criterion = found.criterion;
    result_.edge = found.edge;
    result_.chosen_on = found.chosen_on;
    result_.lambda = search_.lambda();
    result_.smoothing_time = search_.smoothing_time();
    result_.smoothing_times = search_.smoothing_times();
    result_.interval = scale_.interval;
    result_.local_noise = scale_.noise;
    if (options_.sigma) result_.sigmas = search_.sigmas(options_.noise.value_or(result_.noise));
    for (const SmoothingFit& fit : search_.fits().fits) {
      const auto append = [](auto& all, const auto& part) { all.insert(all.end(), part.begin(), part.end()); };
      append(result_.nodes.orientations, fit.nodes.orientations);
      append(result_.nodes.angular_velocities, fit.nodes.angular_velocities);
      append(result_.nodes.angular_accelerations, fit.nodes.angular_accelerations);
      result_.nodes.gyro_correction = fit.nodes.gyro_correction;
      result_.last_step = std::max(result_.last_step, fit.last_step);
      result_.iterations = std::max(result_.iterations, fit.iterations);
    }
    return std::move(result_);
  }

  const Keyframes& recording_;
  const SmoothOptions& options_;
  RecordingScale scale_;
  const std::vector<Stretch>& stretches_;
  SmoothingSearch search_;
  Smoothing result_;
};

/// Which samples become keys, and which lie in no stretch.
void place(Smoothing& smoothing, std::vector<Stretch> stretches, std::size_t samples) {
  std::size_t next = 0;
  const auto leave_out_until = [&](std::size_t key) {
    for (; next < key; ++next) smoothing.samples_in_short_stretches.push_back(next);
  };
  for (const Stretch& stretch : stretches) {
    leave_out_until(stretch.first);
    for (; next < stretch.first + stretch.count; ++next) smoothing.keys.push_back(next);
  }
  leave_out_until(samples);
  smoothing.stretches = std::move(stretches);
}

/// Orientations, then positions where there are some.
Expected<Smoothing> smoothed(const Keyframes& recording, const SmoothOptions& options, std::vector<Stretch> stretches,
                             const Progress& progress) {
  const bool has_positions = !recording.positions().empty();
  OpenEndedWork work(progress, (has_positions ? 1.5 : 1.0) * expected_work(recording.size(), most_times_for_choice));
  auto smoothing = Smoother(recording, options, stretches, work).run();
  if (!smoothing) return smoothing;
  if (has_positions) {
    auto found = smooth_positions(recording, options, stretches, work);
    if (!found) return tl::unexpected(std::move(found.error()));
    smoothing->nodes.positions = std::move(found->positions);
    smoothing->positions = std::move(found->finding);
  }
  place(*smoothing, std::move(stretches), recording.size());
  return smoothing;
}

/// At the times of the keys that were smoothed, with their rates and positions.
Expected<Keyframes> smoothed_keyframes(const Keyframes& recording, const Smoothing& smoothing) {
  const SmoothedNodes& nodes = smoothing.nodes;
  KeyframeData data;
  data.orientations = nodes.orientations;
  data.angular_velocities = nodes.angular_velocities;
  data.angular_accelerations = nodes.angular_accelerations;
  data.positions = nodes.positions;
  for (const std::size_t key : smoothing.keys) data.times.push_back(recording.times()[key]);
  return Keyframes::make(std::move(data));
}

void measure_positions(Smoothing& smoothing, const Keyframes& recording) {
  if (!smoothing.positions) return;
  smoothing.positions->distances = position_distances_of(smoothing, recording, CountedSamples::all);
  smoothing.positions->accepted_distances = position_distances_of(smoothing, recording, CountedSamples::accepted);
}

}  // namespace

Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options, const Progress& progress) {
  const Keyframes& keys = recording.keys;
  return check_recording(keys, options)
      .and_then([&] { return stretches_of(keys, options.penalty, options.gap); })
      .and_then([&](std::vector<Stretch> stretches) -> Expected<Smoothing> {
        return smoothed(keys, options, std::move(stretches), progress);
      })
      .and_then([&](Smoothing smoothing) -> Expected<Smoothing> {
        auto made = smoothed_keyframes(keys, smoothing);
        if (!made) return tl::unexpected(std::move(made.error()));
        smoothing.track = recording.at(smoothing.keys).with_keys(std::move(*made));
        smoothing.track.recipe = recipe_for(smoothing.method, recording);
        if (progress.stopped()) return cancellation();
        smoothing.distances = distances_of(smoothing, keys, CountedSamples::all);
        smoothing.accepted_distances = distances_of(smoothing, keys, CountedSamples::accepted);
        if (progress.stopped()) return cancellation();
        measure_positions(smoothing, keys);
        smoothing.warnings = warnings_of(smoothing);
        progress.at(1.0);
        return smoothing;
      });
}

}}  // namespace orispline
