// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/changing_noise.hpp>
#include <orispline/smooth/correlated_fit.hpp>
#include <orispline/smooth/gyro_fit.hpp>
#include <orispline/smooth/smoothed_band.hpp>
#include <orispline/smooth/smoothing_result.hpp>
#include <orispline/smooth/smoothing_search.hpp>
#include <orispline/smooth/smoothing_stretches.hpp>
#include <orispline/smooth/stated_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Without a gyro.
Penalty penalty_of(const SmoothOptions& options) { return options.penalty.value_or(Penalty::acceleration); }

/// Below them the samples are joined as they are; above, a steady rotation is left or rounding decides.
Interval smoothing_times(const Keyframes& recording, Penalty penalty) {
  const double interval = median_interval(recording.times()),
               span = recording.times().back() - recording.times().front();
  const double longest = penalty == Penalty::jerk ? 5e3 : 1e6;  // in intervals: condition numbers of 1e12
  return {1e-3 * interval, std::min(10.0 * span, longest * interval)};
}

/// check() of the options, and whether they suit the recording. Errors: bad_argument for a time of smoothing or of
/// noise out of range, bad_data for a noise of positions without any.
Expected<void> check_recording(const Keyframes& recording, const SmoothOptions& options) {
  if (auto checked = check(options); !checked) return checked;
  if (options.gyro && recording.data().jumps) return bad_option("jumps", "wanted no `gyro`, which bridges jumps");
  if (options.smoothing_time && recording.size() > 1) {
    const Interval range = smoothing_times(recording, penalty_of(options));
    if (!range.contains(*options.smoothing_time))
      return bad_option("smoothing_time", formatted("found {:.6g} s, wanted {}", *options.smoothing_time,
                                                    text_of(range, &quantities::time)));
  }
  if (options.noise_time && recording.size() > 1)
    if (auto checked = check_noise_time(*options.noise_time, recording.times()); !checked) return checked;
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
  const SearchPlan plan{.penalty = penalty_of(options),
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

constexpr double noisy_freedom =
    0.2;  // of the samples: a curve with more of it follows bends that could be taken for noise
constexpr double doubtful_noise = 1.2;     // between neighbours, over a stated one
constexpr double hidden_intervals = 10.0;  // over which noise would correlate that is told of as hidden

/// The weights of samples over that of one with the usual noise; empty where they are all alike.
std::vector<double> shares_of(const std::vector<double>& noises, double usual) {
  std::vector<double> shares;
  for (const double noise : noises) shares.push_back(usual * usual / (noise * noise));
  return shares;
}

/// The times of all keys, of which some are no samples, and the rate of the gyro that each of them is of, if any. Empty
/// where every key is a sample.
struct KeysBetween {
  std::vector<double> times{};
  std::vector<std::optional<std::size_t>> rates{};
};

/// The steps from a recording to its smoothed orientations.
class Smoother {
 public:
  /// `gyro`: null without one. `noises`: σ of every sample, where they are stated.
  Smoother(const Keyframes& recording, const GyroRates* gyro, const SmoothOptions& options,
           const std::vector<double>& noises, const std::vector<Stretch>& stretches, OpenEndedWork& work)
      : recording_(recording),
        gyro_(gyro),
        options_(options),
        work_(work),
        scale_(scale_of(recording)),
        usual_noise_(options.noise.value_or(noises.empty() ? scale_.noise : median(noises))),
        stretches_(stretches),
        search_(std::in_place, problems_of(recording, stretches, usual_noise_, shares_of(noises, usual_noise_)),
                stretches, plan(), work) {
    result_.noises = noises;
  }

  [[nodiscard]] Expected<Smoothing> run() {
    result_.interval = scale_.interval;
    result_.local_noise = scale_.noise;
    if (gyro_)
      if (auto checked = check_gyro(gyro_plan()); !checked) return tl::unexpected(std::move(checked.error()));
    if (gyro_ && has_to_count_turns(gyro_plan()))
      return fit_with_counted_turns(gyro_plan()).map([this](const GyroFit& fit) { return finished(fit); });
    if (auto found = search_->run(); !found) return tl::unexpected(std::move(found.error()));
    if (auto weighed = weigh_by_noise(); !weighed) return tl::unexpected(std::move(weighed.error()));
    take_search();
    if (auto near = near_to_samples(noise_to_judge()); !near) return tl::unexpected(std::move(near.error()));
    if (options_.noise_time)
      return fit_with_correlated_noise(*search_, {*options_.noise_time, options_.noise, scale_.interval})
          .map([this](const CorrelatedFit& fit) { return finished(fit); });
    if (!gyro_) return finished();
    return fit_with_gyro(gyro_plan(), *search_, noise_to_judge_gyro()).map([this](GyroFit fit) {
      if (fit.finding.used) return finished(fit);
      result_.gyro = std::move(fit.finding);
      return finished();
    });
  }

  [[nodiscard]] const KeysBetween& between() const noexcept { return between_; }

 private:
  [[nodiscard]] SearchPlan plan() const {
    return {.penalty = penalty_of(options_),
            .loss = options_.loss,
            .criterion = options_.noise ? SmoothingCriterion::ubre : SmoothingCriterion::gcv,
            .smoothing_time = options_.smoothing_time,
            .noise = usual_noise_,
            .interval = scale_.interval,
            .adapt = options_.adapt && !options_.noise_time,
            .unit = "°",
            .unit_size = degrees};
  }

  [[nodiscard]] GyroPlan gyro_plan() const { return {recording_, *gyro_, options_, work_}; }

  /// Where the samples are followed as they are the residuals tell little.
  [[nodiscard]] double noise_to_judge() const {
    const bool followed = search_->finding().edge == LambdaChoice::Edge::shortest;
    return followed ? std::max(result_.noise, scale_.noise) : result_.noise;
  }

  /// Where nobody says what the noise is and it changes, samples are weighed by it, if that predicts them better.
  [[nodiscard]] Expected<void> weigh_by_noise() {
    const bool is_open = result_.noises.empty() && !options_.noise && !options_.noise_time &&
                         !options_.smoothing_time && options_.loss != Loss::l2;
    if (!is_open || search_->finding().edge == LambdaChoice::Edge::shortest) return {};
    const SmoothingSearch::Freedom of = search_->freedom();
    if (of.trace > noisy_freedom * of.observations) return {};
    std::vector<double> noises = changing_noise(recording_);
    if (noises.empty()) return {};
    const double usual = std::exchange(usual_noise_, median(noises));
    SmoothingSearch weighed(problems_of(recording_, stretches_, usual_noise_, shares_of(noises, usual_noise_)),
                            stretches_, plan(), work_);
    const bool found = weighed.run().has_value();
    if (work_.stopped()) return cancellation();
    if (found && predicts_better({search_->problems(), search_->fits(), search_->objective()},
                                 {weighed.problems(), weighed.fits(), weighed.objective()})) {
      search_.emplace(std::move(weighed));
      result_.noises = std::move(noises);
    } else {
      usual_noise_ = usual;
    }
    return {};
  }

  /// A stated noise that is too small lets the curve follow the samples, and the residuals then tell too little of it.
  [[nodiscard]] double noise_to_judge_gyro() {
    if (!options_.noise || scale_.noise <= doubtful_noise * *options_.noise) return result_.noise;
    SearchPlan open = plan();
    open.criterion = SmoothingCriterion::gcv;
    open.noise = scale_.noise;
    open.adapt = false;
    SmoothingSearch search(problems_of(recording_, stretches_, open.noise), stretches_, open, work_);
    return search.run() ? std::max(result_.noise, search.residual_noise()) : result_.noise;
  }

  void take_search() {
    const SmoothingSearch::Finding& found = search_->finding();
    result_.noise = search_->residual_noise();
    result_.rejected = found.rejected;
    result_.retained_outlier_runs = found.retained_outlier_runs;
  }

  void take_fits(const StretchFits& fits) {
    for (const SmoothingFit& fit : fits.fits) {
      const auto append = [](auto& all, const auto& part) { all.insert(all.end(), part.begin(), part.end()); };
      append(result_.nodes.orientations, fit.nodes.orientations);
      append(result_.nodes.angular_velocities, fit.nodes.angular_velocities);
      append(result_.nodes.angular_accelerations, fit.nodes.angular_accelerations);
      append(result_.nodes.gyro_corrections, fit.nodes.gyro_corrections);
      result_.nodes.gyro_correction = fit.nodes.gyro_correction;
      result_.last_step = std::max(result_.last_step, fit.last_step);
      result_.iterations = std::max(result_.iterations, fit.iterations);
    }
  }

  /// By the orientations alone.
  [[nodiscard]] Smoothing finished() {
    const SmoothingSearch::Finding& found = search_->finding();
    result_.degrees_of_freedom = 3.0 * search_->freedom().trace;
    result_.criterion = found.criterion;
    result_.edge = found.edge;
    result_.chosen_on = found.chosen_on;
    result_.penalty = penalty_of(options_);
    result_.lambda = search_->lambda();
    result_.smoothing_time = search_->smoothing_time();
    result_.smoothing_times = search_->smoothing_times();
    if (options_.sigma) result_.sigmas = search_->sigmas(options_.noise.value_or(result_.noise));
    take_fits(search_->fits());
    if (!options_.noise && result_.noises.empty()) {
      const double time = hidden_intervals * scale_.interval;
      result_.hidden_noise = {most_correlated_noise(recording_.times(), recording_.orientations(), time), time};
    }
    return std::move(result_);
  }

  /// By the orientations alone, whose noise correlates.
  [[nodiscard]] Smoothing finished(const CorrelatedFit& fit) {
    result_.criterion = SmoothingCriterion::reml;
    result_.edge = fit.chosen.choice.edge;
    result_.chosen_on = fit.chosen.times;
    result_.penalty = fit.objective.penalty;
    result_.lambda = fit.objective.lambda;
    result_.smoothing_time = smoothing_time_of(fit.objective.lambda, fit.objective.penalty, fit.noise, scale_.interval);
    result_.noise = fit.noise;
    result_.correlated_noise = {.sigma = fit.noise, .time = fit.objective.correlation_time};
    if (options_.sigma) result_.sigmas = sigmas_of(fit.problems, fit.objective, fit.fits);
    take_fits(fit.fits);
    return std::move(result_);
  }

  /// With the gyro.
  [[nodiscard]] Smoothing finished(const GyroFit& fit) {
    if (fit.chosen) {
      result_.criterion = SmoothingCriterion::reml;
      result_.edge = fit.chosen->choice.edge;
      result_.chosen_on = fit.chosen->times;
    }
    result_.lambda = fit.objective.lambda;
    result_.smoothing_time = smoothing_time_of(fit.objective.lambda, fit.objective.penalty, fit.noise, fit.interval);
    result_.penalty = fit.objective.penalty;
    if (options_.sigma) result_.sigmas = fit.sigmas;
    take_fits(fit.fits);
    result_.noise = fit.residual_noise;
    result_.gyro = fit.finding;
    if (fit.objective.correlated_noise > 0.0)
      result_.correlated_noise = {.sigma = fit.objective.correlated_noise, .time = fit.objective.correlation_time};
    if (fit.places.size() < result_.nodes.orientations.size()) {
      result_.places = fit.places;
      between_ = {fit.problems.front().times, fit.rates};
    }
    return std::move(result_);
  }

  const Keyframes& recording_;
  const GyroRates* gyro_;
  const SmoothOptions& options_;
  OpenEndedWork& work_;
  RecordingScale scale_;
  double usual_noise_;  // that the weights stand for [rad]
  const std::vector<Stretch>& stretches_;
  std::optional<SmoothingSearch> search_;  // never empty
  Smoothing result_;
  KeysBetween between_;
};

/// Keys with rates and positions.
Expected<Keyframes> smoothed_keyframes(std::vector<double> times, const SmoothedNodes& nodes) {
  return Keyframes::make({.times = std::move(times),
                          .orientations = nodes.orientations,
                          .positions = nodes.positions,
                          .angular_velocities = nodes.angular_velocities,
                          .angular_accelerations = nodes.angular_accelerations,
                          .jumps = true});
}

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

/// What is smoothed, and beside what.
struct Request {
  const Track& recording;
  const GyroRates* gyro;  ///< null without one
  const SmoothOptions& options;
  const Progress& progress;
};

/// A smoothed recording without its track.
struct Smoothed {
  Smoothing smoothing;
  KeysBetween between;
};

/// Orientations, then positions where there are some.
Expected<Smoothed> smoothed(const Request& request, const std::vector<double>& noises, std::vector<Stretch> stretches) {
  const Keyframes& recording = request.recording.keys;
  const bool has_positions = !recording.positions().empty();
  OpenEndedWork work(request.progress,
                     (has_positions ? 1.5 : 1.0) * expected_work(recording.size(), most_times_for_choice));
  Smoother smoother(recording, request.gyro, request.options, noises, stretches, work);
  auto smoothing = smoother.run();
  if (!smoothing) return tl::unexpected(std::move(smoothing.error()));
  if (has_positions) {
    auto found = smooth_positions(recording, request.options, stretches, work);
    if (!found) return tl::unexpected(std::move(found.error()));
    smoothing->nodes.positions = std::move(found->positions);
    smoothing->positions = std::move(found->finding);
  }
  place(*smoothing, std::move(stretches), recording.size());
  return Smoothed{std::move(*smoothing), smoother.between()};
}

/// Positions at the times of all keys, on the path through those of the samples; before the first one and behind the
/// last one they rest.
Expected<void> fill_positions(SmoothedNodes& nodes, const Keyframes& recording, const std::vector<double>& times) {
  if (nodes.positions.empty()) return {};
  KeyframeData data{.orientations = {recording.orientations().begin(), recording.orientations().end()},
                    .positions = std::move(nodes.positions)};
  data.times.assign(recording.times().begin(), recording.times().end());
  const auto curve = Keyframes::make(std::move(data)).and_then([](const Keyframes& keys) {
    return make_pose_curve(Method(smoothed_method), keys);
  });
  if (!curve) return tl::unexpected(curve.error());
  nodes.positions.clear();
  for (const double t : times)
    nodes.positions.push_back(
        curve->position->linear_motion(std::clamp(t, recording.times().front(), recording.times().back())).position);
  return {};
}

/// Of the keys of which some are no samples, with the exact times that are known.
Expected<Track> track_between(const Request& request, SmoothedNodes& nodes, const KeysBetween& between,
                              const std::vector<std::size_t>& places) {
  const Track& recording = request.recording;
  if (auto filled = fill_positions(nodes, recording.keys, between.times); !filled)
    return tl::unexpected(std::move(filled.error()));
  Track track;
  track.name = recording.name;
  track.epoch = recording.epoch;
  const bool are_rows = request.gyro->clock == GyroRates::Clock::of_the_recording && !request.gyro->exact_times.empty();
  if (!recording.exact_times.empty()) {
    std::size_t sample = 0;
    for (std::size_t key = 0; key < between.times.size(); ++key) {
      const bool is_sample = sample < places.size() && places[sample] == key;
      const auto rate = between.rates[key];
      track.exact_times.push_back(is_sample          ? recording.exact_times[sample]
                                  : are_rows && rate ? request.gyro->exact_times[*rate]
                                                     : recording.epoch + Decimal::from_double(between.times[key]));
      sample += is_sample ? 1 : 0;
    }
  }
  return smoothed_keyframes(between.times, nodes).map([&](const Keyframes& keys) {
    track.keys = keys;
    return std::move(track);
  });
}

/// With rates, and with all that belongs to the keys of the recording.
Expected<Track> track_of(const Request& request, Smoothed& found) {
  Smoothing& smoothing = found.smoothing;
  const Track& recording = request.recording;
  if (!smoothing.places.empty()) return track_between(request, smoothing.nodes, found.between, smoothing.places);
  std::vector<double> times;
  for (const std::size_t key : smoothing.keys) times.push_back(recording.keys.times()[key]);
  return smoothed_keyframes(std::move(times), smoothing.nodes).map([&](const Keyframes& keys) {
    return recording.at(smoothing.keys).with_keys(keys);
  });
}

/// Nothing else can, so that no risk without the gyro is known.
bool counts_turns(const GyroFinding& gyro) { return gyro.used && !gyro.risk; }

void measure_positions(Smoothing& smoothing, const Keyframes& recording) {
  if (!smoothing.positions) return;
  smoothing.positions->distances = position_distances_of(smoothing, recording, CountedSamples::all);
  smoothing.positions->accepted_distances = position_distances_of(smoothing, recording, CountedSamples::accepted);
}

Expected<Smoothing> smoothed(const Request& request) {
  const Track& recording = request.recording;
  const Keyframes& keys = recording.keys;
  const Progress& progress = request.progress;
  const auto noises = stated_noise(recording);
  if (!noises) return tl::unexpected(noises.error());
  for (const auto& [name, is_stated] :
       {std::pair{"noise", request.options.noise.has_value()}, {"noise_time", request.options.noise_time.has_value()}})
    if (!noises->empty() && is_stated)
      return bad_option(name, "found the noise of every sample in the recording as well, wanted one of them");
  return check_recording(keys, request.options)
      .and_then([&] { return stretches_of(keys, penalty_of(request.options), request.options.gap); })
      .and_then([&](std::vector<Stretch> stretches) { return smoothed(request, *noises, std::move(stretches)); })
      .and_then([&](Smoothed found) -> Expected<Smoothing> {
        auto track = track_of(request, found);
        if (!track) return tl::unexpected(std::move(track.error()));
        Smoothing& smoothing = found.smoothing;
        smoothing.track = std::move(*track);
        forget_stated_noise(smoothing.track);
        if (smoothing.sigmas) set_band(smoothing.track, *smoothing.sigmas);
        smoothing.track.recipe = recipe_for(smoothing.method, recording);
        smoothing.track.recipe.gap = request.options.gap;
        if (smoothing.gyro && counts_turns(*smoothing.gyro)) smoothing.track.recipe.signs = Signs::as_given;
        if (progress.stopped()) return cancellation();
        smoothing.distances = distances_of(smoothing, keys, CountedSamples::all);
        smoothing.accepted_distances = distances_of(smoothing, keys, CountedSamples::accepted);
        if (progress.stopped()) return cancellation();
        measure_positions(smoothing, keys);
        smoothing.warnings = warnings_of(smoothing, request.options);
        if (auto jumps = jumps_followed(smoothing, keys)) smoothing.warnings.push_back(std::move(*jumps));
        progress.at(1.0);
        return std::move(smoothing);
      });
}

}  // namespace

Expected<void> check(const SmoothOptions& options) {
  if (auto checked = check_ranges(options); !checked) return checked;
  if (options.noise && options.smoothing_time)
    return bad_option("noise", "wanted no `smoothing_time` as well: each determines how smooth");
  if (options.noise_time && options.smoothing_time)
    return bad_option("noise_time", "wanted no `smoothing_time` as well, which is chosen by the noise");
  if (options.noise_time && options.gyro)
    return bad_option("noise_time", "wanted no `gyro`, with which noise that correlates is found");
  if (!options.gyro && options.gyro_noise) return bad_option("gyro_noise", "wanted `gyro` as well");
  if (!options.gyro && options.gyro_offset) return bad_option("gyro_offset", "wanted `gyro` as well");
  if (!options.gyro && options.gyro_bias) return bad_option("gyro_bias", "wanted `gyro` as well");
  if (options.gyro && options.gap) return bad_option("gap", "wanted no `gyro`, which bridges gaps");
  return {};
}

Expected<GyroRates> gyro_rates_in(const Track& recording) {
  GyroRates gyro;
  const auto& rates = recording.keys.angular_velocities();
  for (std::size_t key = 0; key < rates.size(); ++key) {
    if (is_free(rates[key])) continue;
    gyro.times.push_back(recording.keys.times()[key]);
    gyro.rates.push_back(rates[key]);
    if (!recording.exact_times.empty()) gyro.exact_times.push_back(recording.exact_times[key]);
    if (!recording.lines.empty()) gyro.lines.push_back(recording.lines[key]);
  }
  if (!gyro.times.empty()) return gyro;
  return failure(ErrorCode::bad_data, "found no angular velocities of the body, wanted wx,wy,wz of the gyro");
}

Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options, const Progress& progress) {
  if (auto checked = check(options); !checked) return tl::unexpected(std::move(checked.error()));
  if (!options.gyro) return smoothed({recording, nullptr, options, progress});
  return gyro_rates_in(recording).and_then(
      [&](const GyroRates& gyro) { return smooth(recording, gyro, options, progress); });
}

Expected<Smoothing> smooth(const Track& recording, const GyroRates& gyro, const SmoothOptions& options,
                           const Progress& progress) {
  SmoothOptions with_gyro = options;
  with_gyro.gyro = true;
  return smoothed({recording, &gyro, with_gyro, progress});
}

}}  // namespace orispline
