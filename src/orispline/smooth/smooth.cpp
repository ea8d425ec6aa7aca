// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/families/recipe.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/smooth/smoothing_check.hpp>
#include <orispline/smooth/smoothing_gyro.hpp>
#include <orispline/smooth/smoothing_outliers.hpp>
#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double huber_threshold = 2.5, tukey_threshold = 6.0;  // in units of σ
constexpr double tolerance_to_find_outliers = 1e-2;             // of the iteration, likewise

SmoothingObjective objective_of(const SmoothOptions& options, OpenEndedWork& work) {
  return {.penalty = options.penalty,
          .loss = options.loss == Loss::l2 ? LossFunction::l2 : LossFunction::huber,
          .threshold = huber_threshold,
          .work = &work};
}

/// The steps from a recording to its smoothed motion, each of which refines what is known.
class Smoother {
 public:
  Smoother(const Keyframes& recording, const SmoothOptions& options, std::vector<Stretch> stretches,
           const Progress& progress)
      : recording_(recording),
        options_(options),
        scale_(scale_of(recording)),
        noise_(options.noise.value_or(scale_.noise)),
        stretches_(std::move(stretches)),
        problems_(problems_of(recording, stretches_, noise_)),
        work_(progress, expected_work(recording.size(), most_times_for_choice)),
        objective_(objective_of(options, work_)) {}

  [[nodiscard]] Expected<Smoothing> run() {
    fit(options_.loss == Loss::robust ? roughly() : SmoothingIteration{});
    if (options_.loss == Loss::tukey) fit_with_tukey();
    if (work_.stopped()) return cancellation();
    if (options_.loss == Loss::robust)
      if (auto done = fit_without_outliers(); !done) return tl::unexpected(std::move(done.error()));
    if (auto checked = check_fit(); !checked) return tl::unexpected(std::move(checked.error()));
    measure_noise_and_freedom();
    if (const double noise = noise_to_judge(); noise > largest_noise)
      return failure(ErrorCode::bad_data,
                     formatted("no smooth motion is near to the samples: they are {:.3g}° per axis off the best one",
                               noise * degrees));
    if (options_.gyro)
      if (auto done = fit_with_gyro(); !done) return tl::unexpected(std::move(done.error()));
    return finished();
  }

 private:
  /// As well as finding outliers takes.
  [[nodiscard]] SmoothingIteration roughly() const { return {.tolerance = tolerance_to_find_outliers * noise_}; }

  /// With λ as stated or chosen anew, from the present fit if there is one.
  void fit(const SmoothingIteration& iteration = {}) {
    set_lambda(options_.noise ? SmoothingCriterion::ubre : SmoothingCriterion::gcv);
    refit(iteration);
  }

  /// As the smoothing time states it, else by the criterion.
  void set_lambda(SmoothingCriterion criterion) {
    if (options_.smoothing_time)
      objective_.lambda = lambda_of(*options_.smoothing_time, options_.penalty, noise_, scale_.interval);
    else choose(criterion);
  }

  void choose(SmoothingCriterion criterion) {
    const StretchProblems parts = representative_parts(problems_, most_times_for_choice);
    const auto near = result_.criterion == criterion ? std::optional(smoothing_time()) : std::nullopt;
    const LambdaChoice choice = chosen_lambda(parts, objective_, criterion, noise_, scale_.interval, near);
    objective_.lambda = choice.lambda;
    result_.criterion = criterion;
    result_.edge = choice.edge;
    result_.chosen_on = 0;
    for (const SmoothingProblem& part : parts) result_.chosen_on += part.size();
  }

  void refit(const SmoothingIteration& iteration = {}) {
    fits_ = fit_stretches(problems_, objective_, iteration, fits_);
  }

  [[nodiscard]] double smoothing_time() const {
    return smoothing_time_of(objective_.lambda, options_.penalty, noise_, scale_.interval);
  }

  void fit_with_tukey() {
    objective_.loss = LossFunction::tukey;
    objective_.threshold = tukey_threshold;
    refit();
    for (std::size_t k = 0; k < stretches_.size(); ++k)
      for (std::size_t i = 0; i < stretches_[k].count; ++i)
        if (fits_.fits[k].loss_weights[i] == 0.0) result_.rejected.push_back(stretches_[k].first + i);
  }

  /// The first search is beside Huber's fit, which outliers pull little but which lags behind strikes; the second one
  /// beside a fit whose τ was chosen without outliers and with the strikes.
  [[nodiscard]] Expected<void> fit_without_outliers() {
    objective_.loss = LossFunction::l2;
    for (int search = 0; search < 2; ++search) {
      const auto before = result_.rejected;
      if (auto found = find_outliers(); !found) return found;
      if (search > 0 && result_.rejected == before) refit();
      else fit(search > 0 ? SmoothingIteration{} : roughly());
      if (work_.stopped()) return cancellation();
    }
    return {};
  }

  /// Leaves out what is far, and takes back what the neighbours do not call an outlier.
  [[nodiscard]] Expected<void> find_outliers() {
    const double noise = std::max(noise_, noise_by_median());
    const auto errors = [&] { return prediction_errors(problems_, fits_, objective_, noise); };
    const FarSamples candidates = far_candidates(errors(), stretches_);
    readmit(problems_, noise_);
    auto far = reject(problems_, stretches_, candidates, options_.penalty);
    if (!far) return tl::unexpected(std::move(far.error()));
    if (!far->single.empty()) {
      refit(roughly());
      far = judged(*far, errors(), stretches_);
      readmit(problems_, noise_);
      if (far = reject(problems_, stretches_, *far, options_.penalty); !far)
        return tl::unexpected(std::move(far.error()));
    }
    result_.rejected = std::move(far->single);
    result_.retained_outlier_runs = std::move(far->in_runs);
    return {};
  }

  /// Whether the iteration ended by itself, and whether the loss is one of outliers only.
  [[nodiscard]] Expected<void> check_fit() const {
    if (work_.stopped()) return cancellation();
    if (!converged(fits_, noise_))
      return failure(
          ErrorCode::not_converged,
          "no smooth motion was found: the iteration did not come to an end, wanted another smoothing time or "
          "another noise");
    std::size_t faults = options_.loss == Loss::robust ? result_.rejected.size() : 0, all = 0;
    for (const SmoothingFit& fit : fits_.fits) {
      all += fit.residuals.size();
      faults += static_cast<std::size_t>(std::ranges::count_if(
          fit.residuals, [this](const Eigen::Vector3d& r) { return r.norm() > far_threshold * noise_; }));
    }
    if (2 * faults <= all || options_.loss == Loss::l2) return {};
    return failure(
        ErrorCode::bad_data,
        formatted("{} of {} samples are farther than 5 σ from the best motion, σ = {:.3g}°, wanted a larger noise, "
                  "a shorter smoothing time, or the loss l2, which has no outliers",
                  faults, all, noise_ * degrees));
  }

  /// What of the data the curve takes up, per axis, and what is left to tell the noise: trace + rest = observations.
  struct Freedom {
    double trace, rest, observations;
  };

  [[nodiscard]] Freedom freedom() const {
    const auto count = static_cast<double>(observations(problems_));
    const double trace = hat_trace(problems_, fits_, options_.penalty, objective_.lambda);
    return {trace, std::max(0.0, count - trace), count};
  }

  /// σ per axis [rad] of the residuals, of which outliers are few.
  [[nodiscard]] double noise_by_median() const {
    std::vector<double> lengths;
    for (const SmoothingFit& fit : fits_.fits)
      for (const Eigen::Vector3d& r : fit.residuals) lengths.push_back(r.norm());
    const Freedom of = freedom();
    if (!(of.rest > 0.0)) return 0.0;
    return median_of(std::move(lengths)) / (median_length * std::sqrt(of.rest / of.observations));
  }

  void measure_noise_and_freedom() {
    const Freedom of = freedom();
    result_.noise = of.rest > 0.0 ? noise_ * std::sqrt(fits_.data() / (3.0 * of.rest)) : 0.0;
    result_.degrees_of_freedom = 3.0 * of.trace;
  }

  /// Where the samples are followed as they are the residuals tell little.
  [[nodiscard]] double noise_to_judge() const {
    const bool followed = result_.edge == LambdaChoice::Edge::shortest;
    return followed ? std::max(result_.noise, scale_.noise) : result_.noise;
  }

  [[nodiscard]] Expected<void> fit_with_gyro() {
    auto faults = gyro_faults(fits_, recording_, stretches_);
    if (!faults) return tl::unexpected(std::move(faults.error()));
    result_.rejected_gyro = std::move(*faults);
    const double orientation_noise = options_.noise.value_or(std::max(least_noise, result_.noise));
    const double ratio = noise_ / orientation_noise;
    for (SmoothingProblem& problem : problems_)
      for (double& weight : problem.weights) weight *= ratio * ratio;
    noise_ = orientation_noise;
    result_.gyro_noise = options_.gyro_noise.value_or(
        std::max(least_noise, local_noise(recording_.times(), recording_.angular_velocities())));
    result_.degrees_of_freedom.reset();
    add_gyro(problems_, recording_, stretches_, *result_.gyro_noise);
    for (const std::size_t sample : result_.rejected_gyro) leave_out_gyro(sample);
    objective_.bias = SmoothingObjective::Bias::constant;
    set_lambda(SmoothingCriterion::reml);
    refit();
    return check_fit();
  }

  void leave_out_gyro(std::size_t sample) {
    for (std::size_t k = 0; k < stretches_.size(); ++k)
      if (const auto& [first, count] = stretches_[k]; sample >= first && sample < first + count)
        problems_[k].gyro_weights[sample - first] = 0.0;
  }

  [[nodiscard]] Smoothing finished() {
    result_.lambda = objective_.lambda;
    result_.smoothing_time = smoothing_time();
    result_.interval = scale_.interval;
    result_.local_noise = scale_.noise;
    for (SmoothingFit& fit : fits_.fits) {
      const auto append = [](auto& all, const auto& part) { all.insert(all.end(), part.begin(), part.end()); };
      append(result_.nodes.orientations, fit.nodes.orientations);
      append(result_.nodes.angular_velocities, fit.nodes.angular_velocities);
      append(result_.nodes.angular_accelerations, fit.nodes.angular_accelerations);
      result_.nodes.gyro_correction = fit.nodes.gyro_correction;
      result_.last_step = std::max(result_.last_step, fit.last_step);
      result_.iterations = std::max(result_.iterations, fit.iterations);
    }
    std::size_t next = 0;
    const auto leave_out_until = [&](std::size_t key) {
      for (; next < key; ++next) result_.samples_in_short_stretches.push_back(next);
    };
    for (const Stretch& stretch : stretches_) {
      leave_out_until(stretch.first);
      for (; next < stretch.first + stretch.count; ++next) result_.keys.push_back(next);
    }
    leave_out_until(recording_.size());
    result_.stretches = std::move(stretches_);
    return std::move(result_);
  }

  const Keyframes& recording_;
  const SmoothOptions& options_;
  RecordingScale scale_;
  double noise_;  // that the weights stand for [rad]
  std::vector<Stretch> stretches_;
  StretchProblems problems_;
  OpenEndedWork work_;
  SmoothingObjective objective_;
  StretchFits fits_;
  Smoothing result_;
};

/// At the times of the keys that were smoothed, with their rates; their positions as they were.
Expected<Keyframes> smoothed_keyframes(const Keyframes& recording, const Smoothing& smoothing) {
  const SmoothedNodes& nodes = smoothing.nodes;
  KeyframeData data;
  data.orientations = nodes.orientations;
  data.angular_velocities = nodes.angular_velocities;
  data.angular_accelerations = nodes.angular_accelerations;
  for (const std::size_t key : smoothing.keys) {
    data.times.push_back(recording.times()[key]);
    if (!recording.positions().empty()) data.positions.push_back(recording.positions()[key]);
  }
  return Keyframes::make(std::move(data));
}

}  // namespace

Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options, const Progress& progress) {
  const Keyframes& keys = recording.keys;
  return check_recording(keys, options)
      .and_then([&] { return stretches_of(keys, options.penalty, options.gap); })
      .and_then([&](std::vector<Stretch> stretches) -> Expected<Smoothing> {
        return Smoother(keys, options, std::move(stretches), progress).run();
      })
      .and_then([&](Smoothing smoothing) -> Expected<Smoothing> {
        auto smoothed = smoothed_keyframes(keys, smoothing);
        if (!smoothed) return tl::unexpected(std::move(smoothed.error()));
        smoothing.track = recording.at(smoothing.keys).with_keys(std::move(*smoothed));
        smoothing.track.recipe = recipe_for(smoothing.method, recording);
        smoothing.distances = distances_of(smoothing, keys, CountedSamples::all);
        smoothing.accepted_distances = distances_of(smoothing, keys, CountedSamples::accepted);
        smoothing.warnings = warnings_of(smoothing);
        progress.at(1.0);
        return smoothing;
      });
}

}  // namespace orispline::inline ORISPLINE_ABI
