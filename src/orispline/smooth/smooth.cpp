// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_gyro.hpp>
#include <orispline/smooth/smoothing_result.hpp>
#include <orispline/smooth/smoothing_search.hpp>
#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Below them the samples are joined as they are; above, a steady rotation is left or rounding decides.
Interval smoothing_times(const Keyframes& recording, Penalty penalty) {
  const double interval = median_interval(recording.times()),
               span = recording.times().back() - recording.times().front();
  const double longest = penalty == Penalty::jerk ? 5e3 : 1e6;  // in intervals: condition numbers of 1e12
  return {1e-3 * interval, std::min(10.0 * span, longest * interval)};
}

/// check() of the options, and whether they suit the recording. Errors: bad_argument for a smoothing time out of range,
/// bad_data for a gyro without rates.
Expected<void> check_recording(const Keyframes& recording, const SmoothOptions& options) {
  if (auto checked = check(options); !checked) return checked;
  if (options.smoothing_time && recording.size() > 1) {
    const Interval range = smoothing_times(recording, options.penalty);
    if (!range.contains(*options.smoothing_time))
      return bad_option("smoothing_time", formatted("found {:.6g} s, wanted {}", *options.smoothing_time,
                                                    text_of(range, &quantities::time)));
  }
  if (options.gyro && recording.angular_velocities().empty())
    return failure(ErrorCode::bad_data, "found no angular velocities of the body, wanted wx,wy,wz of the gyro");
  if (options.gyro)
    if (const auto free = std::ranges::find_if(recording.angular_velocities(), is_free);
        free != recording.angular_velocities().end())
      return failure(ErrorCode::bad_data, "the angular velocity is left free, wanted that of the gyro at every sample",
                     {.key = static_cast<std::size_t>(free - recording.angular_velocities().begin())});
  if (options.position_noise && recording.positions().empty())
    return failure(ErrorCode::bad_data, "found no positions, wanted px,py,pz for `position_noise`");
  return {};
}

/// Positions at the times of all stretches [m], and what is to be said of them.
struct SmoothedPositions {
  std::vector<Eigen::Vector3d> positions{};
  PositionSmoothing finding{};
};

constexpr double rounding_of_doubles = 1e-14;  // of a sum of a few positions, relative to the largest component
constexpr double rounding_of_fits = 1e-11;     // relative to the extent
constexpr double shortest_length = 1e-30;      // [m], whose square is far from the smallest double

/// The largest component of a position as seen from the origin [m].
double extent_of(std::span<const Eigen::Vector3d> positions, const Eigen::Vector3d& origin) {
  double largest = 0.0;
  for (const Eigen::Vector3d& p : positions) largest = std::max(largest, (p - origin).lpNorm<Eigen::Infinity>());
  return largest;
}

/// σ per axis [m] between neighbours; 0 where positions lie on straight lines to rounding.
double local_noise_of(const Keyframes& recording) {
  const double size = extent_of(recording.positions(), Eigen::Vector3d::Zero());
  return local_noise(recording.times(), recording.positions(), std::max(shortest_length, rounding_of_doubles * size));
}

/// As they are, without noise that could be told.
SmoothedPositions as_recorded(const Keyframes& recording, const std::vector<Stretch>& stretches) {
  SmoothedPositions result;
  for (const auto& [first, count] : stretches) {
    const auto part = recording.positions().subspan(first, count);
    result.positions.insert(result.positions.end(), part.begin(), part.end());
  }
  return result;
}

/// In which positions are smoothed: from where they are seen, the unit [m], and what is rounding of the fit [m].
struct PositionScale {
  Eigen::Vector3d origin;
  double unit, resolution;
};

/// What a search found, in metres. Where there is no noise to take away, what is not rejected stays as it is.
SmoothedPositions in_metres(const SmoothingSearch& search, const Keyframes& recording,
                            const std::vector<Stretch>& stretches, const PositionScale& scale) {
  const SmoothingSearch::Finding& found = search.finding();
  SmoothedPositions result = as_recorded(recording, stretches);
  PositionSmoothing& finding = result.finding;
  finding.edge = found.edge;
  finding.criterion = found.criterion;
  finding.chosen_on = found.chosen_on;
  finding.rejected = found.rejected;
  finding.retained_outlier_runs = found.retained_outlier_runs;
  finding.noise = scale.unit * search.residual_noise();
  const bool noisy = found.edge != LambdaChoice::Edge::shortest && finding.noise > scale.resolution;
  if (noisy || !found.criterion) finding.smoothing_time = search.smoothing_time();
  auto next = result.positions.begin();
  for (std::size_t k = 0; k < stretches.size(); ++k)
    for (std::size_t i = 0; i < stretches[k].count; ++i, ++next)
      if (finding.smoothing_time || std::ranges::binary_search(finding.rejected, stretches[k].first + i))
        *next = scale.origin + scale.unit * search.fits().fits[k].nodes.positions[i];
  return result;
}

/// The positions of a recording, which has some, smoothed as its orientations are, but for themselves. Errors: those of
/// SmoothingSearch::run(), which name them.
Expected<SmoothedPositions> smooth_positions(const Keyframes& recording, const SmoothOptions& options,
                                             const std::vector<Stretch>& stretches, OpenEndedWork& work) {
  const double local = local_noise_of(recording);
  if (!(local > 0.0)) return as_recorded(recording, stretches);  // straight lines stay what they are
  PositionScale scale{.origin = recording.positions()[stretches.front().first], .unit = 1.0, .resolution = 0.0};
  scale.resolution = rounding_of_fits * extent_of(recording.positions(), scale.origin);
  scale.unit = options.position_noise.value_or(std::max(scale.resolution, local));
  const bool chosen = options.position_noise || !options.smoothing_time;
  const SearchPlan plan{.penalty = options.penalty,
                        .loss = options.loss,
                        .criterion = options.position_noise ? SmoothingCriterion::ubre : SmoothingCriterion::gcv,
                        .smoothing_time = chosen ? std::nullopt : options.smoothing_time,
                        .interval = median_interval(recording.times()),
                        .unit = " m",
                        .unit_size = scale.unit};
  SmoothingSearch search(position_problems_of(recording, stretches, scale.origin, scale.unit), stretches, plan, work);
  return search.run()
      .map([&] {
        SmoothedPositions result = in_metres(search, recording, stretches, scale);
        result.finding.local_noise = local;
        return result;
      })
      .map_error([](Error error) {
        if (error.code != ErrorCode::cancelled) error.message = formatted("positions: {}", error.message);
        return error;
      });
}

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

Expected<void> check(const SmoothOptions& options) {
  if (auto checked = check_ranges(options); !checked) return checked;
  if (options.noise && options.smoothing_time)
    return bad_option("noise", "wanted no `smoothing_time` as well: each determines how smooth");
  if (options.gyro_noise && !options.gyro) return bad_option("gyro_noise", "wanted `gyro` as well");
  if (options.gyro && options.gap) return bad_option("gap", "wanted no `gyro`, which bridges gaps");
  return {};
}

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
        smoothing.track = recording.at(smoothing.keys).with_keys(*made);
        smoothing.track.recipe = recipe_for(smoothing.method, recording);
        smoothing.track.recipe.gap = options.gap;
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
