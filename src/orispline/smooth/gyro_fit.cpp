// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_fit.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/gyro_faults.hpp>
#include <orispline/smooth/gyro_model.hpp>
#include <orispline/smooth/gyro_repairs.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_rounds = 3;           // of looking for faults beside an alignment, and of aligning without them
constexpr double sure_offset = 3.0;      // in its standard deviations: a smaller one is none
constexpr double most_rate_noise = 3.0;  // over that between neighbours, of a gyro that is understood
constexpr double sure_gain = 0.6, least_gain = 0.9;   // of the error without the gyro
constexpr double harmless_error = 4.0 * least_noise;  // [rad]: of numbers in single precision
constexpr std::size_t fewest_rates = 3;
constexpr double least_drift = 1e-3;  // of a bias that is constant: over the recording, in units of the gyro's noise
constexpr double longest_sure_step = 0.5 * std::numbers::pi;  // [rad]

double gyro_noise_of(const GyroPlan& plan) {
  return plan.options.gyro_noise.value_or(std::max(least_noise, local_noise(plan.gyro.times, plan.gyro.rates)));
}

SeenPoses poses_of(const GyroPlan& plan, double noise) {
  return {.times = plan.recording.times(),
          .orientations = plan.recording.orientations(),
          .counts = std::vector<bool>(plan.recording.size(), true),
          .fitted = nullptr,
          .noise = noise};
}

/// Whether no step between successive orientations is so long that it may go the other way round.
bool are_motion(const SeenPoses& poses) {
  for (std::size_t i = 0; i + 1 < poses.times.size(); ++i)
    if (angular_distance(poses.orientations[i], poses.orientations[i + 1]) > longest_sure_step) return false;
  return true;
}

CountedRates all_rates(const GyroRates& gyro) { return CountedRates(gyro.times.size(), true); }

/// The orientations that the fit of one stretch has by itself.
SeenPoses seen_by(const GyroPlan& plan, const SmoothingSearch& without, double noise) {
  SeenPoses poses = poses_of(plan, noise);
  poses.fitted = &without.fits().fits.front().nodes;
  for (std::size_t i = 0; i < poses.counts.size(); ++i) poses.counts[i] = without.problems().front().weights[i] > 0.0;
  return poses;
}

/// Offset, correction and faults of a gyro.
struct Seen {
  GyroAlignment alignment;
  CountedRates counts;
};

Seen seen_gyro(const GyroPlan& plan, const SeenPoses& poses, double gyro_noise) {
  const bool finds_offset = !plan.options.gyro_offset;
  Seen seen{{.offset = plan.options.gyro_offset.value_or(0.0)}, all_rates(plan.gyro)};
  if (finds_offset) seen.alignment.offset = coarse_offset(poses, plan.gyro, seen.counts);
  for (int round = 0; round < most_rounds; ++round) {
    const bool any = leave_out_faults(poses, plan.gyro, seen.alignment, seen.counts);
    if (round > 0 && !any) break;
    seen.alignment = aligned(poses, plan.gyro, seen.counts, gyro_noise, seen.alignment, finds_offset);
  }
  const double span = poses.times.back() - poses.times.front();
  if (!(seen.alignment.offset_sigma < span)) seen.alignment.offset_sigma.reset();  // the motion does not tell it
  const auto sigma = seen.alignment.offset_sigma;
  if (finds_offset && (!sigma || std::abs(seen.alignment.offset) < sure_offset * *sigma)) {
    seen.alignment.offset = 0.0;
    seen.alignment = aligned(poses, plan.gyro, seen.counts, gyro_noise, seen.alignment, false);
    seen.alignment.offset_sigma = sigma;
  }
  return seen;
}

/// Near such an alignment.
GyroModelPlan model_plan(const GyroPlan& plan, const SeenPoses& poses, const GyroAlignment& near) {
  return {.near = {.correction = near.correction, .offset = near.offset},
          .rate_noise = gyro_noise_of(plan) * std::sqrt(median_interval(plan.gyro.times)),
          .pose_noise = poses.noise,
          .finds_offset = !plan.options.gyro_offset,
          .finds_clock_rate = plan.gyro.clock == GyroRates::Clock::own,
          .finds_trend = plan.options.gyro_bias != GyroBias::constant,
          .states_pose_noise = plan.options.noise.has_value(),
          .bias = plan.options.gyro_bias};
}

/// Where the gyro says nothing, the motion is as stiff as the orientations alone want it: `alone` is their λ, in units
/// of the weights of the fit.
void stiffen(SmoothingProblem& problem, const std::vector<bool>& unled, double lambda, double alone) {
  if (std::ranges::find(unled, true) == unled.end()) return;
  for (const bool is_unled : unled) problem.relative_lambdas.push_back(is_unled ? alone / lambda : 1.0);
}

/// The λ of the jerk's penalty with the smoothing time of one of the acceleration's.
double lambda_of_jerk(double of_acceleration, const SeenPoses& poses) {
  const double interval = median_interval(poses.times);
  return lambda_of(smoothing_time_of(of_acceleration, Penalty::acceleration, poses.noise, interval), Penalty::jerk,
                   poses.noise, interval);
}

/// The smoothing time that the changes of the rates suggest: that of a penalty of the acceleration for which they are a
/// random walk. Absent where they are noise.
std::optional<double> time_of_rates(const GyroFit& fit) {
  const SmoothingProblem& problem = fit.problems.front();
  double squares = 0.0, count = 0.0, time = 0.0;
  for (std::size_t i = 0; i + 1 < problem.size(); ++i) {
    if (problem.gyro_weights[i] == 0.0 || problem.gyro_weights[i + 1] == 0.0) continue;
    squares +=
        (problem.gyro[i + 1] - problem.gyro[i]).squaredNorm() / 3.0 - 2.0 * fit.finding.noise * fit.finding.noise;
    time += problem.times[i + 1] - problem.times[i];
    count += 1.0;
  }
  if (count == 0.0 || !(squares > 0.0)) return std::nullopt;
  const double shortest = 0.2 * fit.interval, longest = 200.0 * fit.interval;
  const double tau = smoothing_time_of(time / squares, Penalty::acceleration, fit.noise, fit.interval);
  return std::clamp(tau, shortest, longest);
}

/// λ by the restricted likelihood; what the fit with it may begin with is returned.
StretchFits choose_lambda(GyroFit& result, const StretchFits& start, SmoothingObjective& objective) {
  ChosenLambda chosen = chosen_lambda(result.problems, start, objective, SmoothingCriterion::reml, result.noise,
                                      result.interval, time_of_rates(result));
  objective.lambda = chosen.choice.lambda;
  StretchFits near = std::exchange(chosen.fits, {});
  result.chosen = std::move(chosen);
  return near.fits.empty() ? start : near;
}

/// A gyro whose rates are those of the body, but for a bias, and how wrong it and the orientations are.
struct Calibrated {
  const GyroRates& rates;
  GyroAlignment alignment;
  CountedRates counts;
  double rate_noise;  // σ per axis [rad/s]
  GyroNoises noises;
  std::array<bool, 3> dead_axes{};
};

/// What of the objective the noises say. The weights of the orientations stand for their white noise from then on.
void take_noises(SmoothingObjective& objective, SmoothingProblem& problem, const Calibrated& gyro, double pose_noise) {
  const GyroNoises& noises = gyro.noises;
  if (noises.correlated == 0.0) return;
  objective.correlated_noise = noises.correlated;
  objective.correlation_time = noises.correlation_time;
  const double ratio = pose_noise / noises.white;
  for (double& weight : problem.weights) weight *= ratio * ratio;
}

/// λ as stated or by the restricted likelihood, and the fit with it. `alone`: λ of the orientations by themselves.
Expected<GyroFit> fitted(const GyroPlan& plan, const SeenPoses& poses, const Calibrated& gyro,
                         SmoothingObjective objective, std::optional<double> alone) {
  GyroRows rows = rows_of(poses, gyro.rates, gyro.counts, gyro.rate_noise, gyro.alignment);
  GyroFit result;
  result.noise = poses.noise;
  result.places = std::move(rows.places);
  result.rates = std::move(rows.rates);
  result.interval = median_interval(rows.problem.times);
  result.finding = {
      .noise = gyro.rate_noise, .offset = gyro.alignment.offset, .offset_sigma = gyro.alignment.offset_sigma};
  for (std::size_t k = 0; k < gyro.counts.size(); ++k)
    if (!gyro.counts[k]) result.finding.rejected.push_back(k);
  result.problems.push_back(std::move(rows.problem));
  SmoothingProblem& problem = result.problems.front();
  problem.dead_gyro_axes = gyro.dead_axes;
  StretchFits start{{{.nodes = std::move(rows.start)}}};
  objective.bias = SmoothingObjective::Bias::constant;
  if (gyro.noises.drift > 0.0 || gyro.noises.correlated > 0.0) {  // with correlated noise a constant bias hardly drifts
    objective.bias = SmoothingObjective::Bias::drifting;
    objective.drift = std::max(gyro.noises.drift,
                               least_drift * gyro.rate_noise / std::sqrt(problem.times.back() - problem.times.front()));
  }
  if (gyro.noises.drift > 0.0) result.finding.drift = gyro.noises.drift;
  if (alone && !plan.options.penalty && !plan.options.smoothing_time) {
    // The rates tell the acceleration, up to an end that they do not reach too.
    objective.penalty = Penalty::jerk;
    alone = lambda_of_jerk(*alone, poses);
  }
  if (plan.options.smoothing_time)
    objective.lambda = lambda_of(*plan.options.smoothing_time, objective.penalty, poses.noise, result.interval);
  else start = choose_lambda(result, start, objective);
  // λ was chosen as if all noise were white: a motion that follows correlated noise would be as likely.
  take_noises(objective, problem, gyro, poses.noise);
  if (alone && result.chosen) stiffen(problem, rows.unled, objective.lambda, *alone);
  result.fits = fit_stretches(result.problems, objective, {}, start);
  result.objective = objective;
  if (objective.stopped()) return cancellation();
  if (!converged(result.fits, poses.noise)) return no_end_found();
  return result;
}

/// What the model of a gyro says of it, whose rates were turned by `mount` before.
void tell(const GyroModel& model, const Eigen::Matrix3d& mount, GyroFinding& finding) {
  namespace columns = calibration_columns;
  if (model.has_scale) {
    const Eigen::Array3d shares = 1.0 + model.values.segment<3>(columns::scale).array();
    finding.scale = {.value = (1.0 / shares - 1.0).matrix(), .sigma = model.sigmas.segment<3>(columns::scale)};
  }
  if (const Eigen::Quaterniond turned(mount); model.has_mount || turned.vec().norm() > 0.0) {
    const Eigen::AngleAxisd whole(exp<double>(model.values.segment<3>(columns::mount)) * turned);
    finding.mount = {.value = whole.angle() * whole.axis(), .sigma = model.sigmas.segment<3>(columns::mount)};
  }
  if (model.has_trend)
    finding.trend = {.value = model.values.segment<3>(columns::trend),
                     .sigma = model.sigmas.segment<3>(columns::trend)};
  if (model.has_clock_rate)
    finding.clock_rate = {.value = model.values[columns::clock_rate], .sigma = model.sigmas[columns::clock_rate]};
}

/// By the posterior of the fit, which takes the calibration for known.
NodeSigmas posterior_of(const GyroFit& fit) {
  return node_sigmas(fit.problems.front(), fit.objective, fit.fits.fits.front().nodes);
}

/// Sum of the variances of the orientations.
double variance_at(const std::vector<std::size_t>& places, const NodeSigmas& sigmas) {
  double sum = 0.0;
  for (const std::size_t place : places) sum += sigmas.orientations[place].squaredNorm();
  return sum;
}

/// With a further variance of every turn per axis [rad²].
NodeSigmas widened(NodeSigmas sigmas, double variance) {
  const auto widen = [variance](double& sigma) { sigma = std::sqrt(sigma * sigma + variance); };
  for (Eigen::Vector3d& sigma : sigmas.orientations)
    for (double& of_axis : sigma) widen(of_axis);
  for (auto& within : sigmas.to_next)
    for (double& sigma : within) widen(sigma);
  return sigmas;
}

/// σ of the orientations per axis [rad] by their residuals, less the freedom that the motion has.
double residual_noise(const GyroFit& fit, double posterior) {
  const SmoothingProblem& problem = fit.problems.front();
  double squares = 0.0, freedom = 3.0 * static_cast<double>(fit.places.size()) - posterior / (fit.noise * fit.noise);
  for (const std::size_t place : fit.places)
    squares += problem.share(place) * fit.fits.fits.front().residuals[place].squaredNorm();
  return std::sqrt(squares / std::max(3.0, freedom));
}

/// Sum of the squares by which the motion without the gyro is off that with it.
double squares_apart(const GyroFit& fit, const SmoothingSearch& without) {
  const auto& with = fit.fits.fits.front().nodes.orientations;
  const auto& alone = without.fits().fits.front().nodes.orientations;
  double sum = 0.0;
  for (std::size_t i = 0; i < fit.places.size(); ++i) {
    const double distance = angular_distance(with[fit.places[i]], alone[i]);
    sum += distance * distance;
  }
  return sum;
}

/// λ of the orientations by themselves, beside weights of 1/noise² of a usual sample that counts.
double lambda_alone(const SmoothingSearch& without, double noise) {
  const SmoothingProblem& problem = without.problems().front();
  double weight = 0.0;
  for (std::size_t i = 0; i < problem.size(); ++i) weight = std::max(weight, problem.weights[i] / problem.share(i));
  return without.lambda() / (weight * noise * noise);
}

/// As a gyro stands to orientations where no more can be told.
GyroModel uncalibrated(const SeenPoses& poses, const GyroAlignment& alignment, double rate_noise) {
  return {.calibration = {.correction = alignment.correction, .offset = alignment.offset},
          .noises = {.rate = rate_noise, .white = poses.noise},
          .seen = poses.times.size()};
}

/// Root mean square of the error that the orientations say they have by themselves [rad].
double error_alone(const SmoothingSearch& without, double noise) {
  return noise * std::sqrt(3.0 * without.freedom().trace / without.freedom().observations);
}

/// Why a gyro does not count. `is_clean`: its rates are hardly noisier than neighbouring ones tell.
GyroFinding::Doubt doubt_of(const GyroModel& model, bool reaches, bool is_clean, bool gains) {
  using enum GyroFinding::Doubt;
  if (!reaches) return reach;
  if (model.noises.clock > 0.0) return clock;
  return is_clean && (model.explains || gains) ? gain : rates;
}

/// Whether the gyro counts. By its model the motion with it is the better the farther the other one is away: the error
/// of the best estimate is not correlated with what any estimate says. That is believed where the rates explain the
/// motion and are hardly noisier than their neighbours tell; else the orientations have to be surer of themselves than
/// without the gyro, by the residuals that they have alone, and much surer where no rates would explain as much.
void judge(GyroFit& fit, const GyroModel& model, const SmoothingSearch& without, double noise,
           double local_rate_noise) {
  const auto count = static_cast<double>(fit.places.size());
  NodeSigmas sigmas = posterior_of(fit);
  const double posterior = variance_at(fit.places, sigmas), variance = posterior + model.variance,
               with = std::sqrt(variance / count),
               without_by_gyro = std::sqrt((variance + squares_apart(fit, without)) / count),
               alone = error_alone(without, noise);
  const bool reaches = 2 * model.seen > fit.places.size();
  const bool is_clean = model.noises.rate < most_rate_noise * local_rate_noise;
  const bool counts = model.explains ? (is_clean && with < sure_gain * without_by_gyro) || with < least_gain * alone
                                     : with < sure_gain * alone;
  fit.finding.used = with <= harmless_error || (reaches && model.noises.clock == 0.0 && counts);
  if (!fit.finding.used) fit.finding.doubt = doubt_of(model, reaches, is_clean, with < alone);
  fit.finding.risk = {.with = with, .without = fit.finding.used ? without_by_gyro : alone};
  fit.residual_noise = model.noises.correlated > 0.0 ? model.noises.white : residual_noise(fit, posterior);
  fit.sigmas = widened(std::move(sigmas), std::max(0.0, model.variance) / (3.0 * count));
}

}  // namespace

Expected<void> check_gyro(const GyroPlan& plan) {
  const auto& times = plan.gyro.times;
  if (times.size() < fewest_rates)
    return failure(ErrorCode::bad_data,
                   formatted("found {} of the gyro, wanted at least {}", counted(times.size(), "rate"), fewest_rates));
  if (times.size() != plan.gyro.rates.size())
    return failure(ErrorCode::bad_data,
                   formatted("found {} times and {} rates of the gyro, wanted one rate for each time", times.size(),
                             plan.gyro.rates.size()));
  for (std::size_t k = 0; k < times.size(); ++k)
    if (!plan.gyro.rates[k].allFinite() || !std::isfinite(times[k]) || (k > 0 && times[k] <= times[k - 1]))
      return failure(ErrorCode::bad_data,
                     formatted("rate {} of the gyro: its time {} s or a number is not finite, or the time "
                               "does not come after the one before it",
                               k, times[k]));
  const auto poses = plan.recording.times();
  const double offset = plan.options.gyro_offset.value_or(0.0), span = poses.back() - poses.front();
  const bool one_clock = plan.gyro.clock == GyroRates::Clock::of_the_recording;
  if (one_clock && std::abs(offset) >= span && span > 0.0)
    return bad_option(
        "gyro_offset",
        formatted("found {:.6g} s, wanted less than the duration of the recording of {:.6g} s", offset, span));
  const double first = times.front() - offset, last = times.back() - offset;
  if (first < poses.back() && last > poses.front()) return {};
  if (plan.options.gyro_offset)
    return bad_option("gyro_offset",
                      formatted("found {:.12g} s, which brings the rates to {:.12g} s to {:.12g} s, wanted them to "
                                "overlap the recording, which is from {:.12g} s to {:.12g} s",
                                offset, first, last, poses.front(), poses.back()));
  return failure(
      ErrorCode::bad_data,
      formatted("the rates of the gyro are from {:.12g} s to {:.12g} s and do not overlap the recording, which is "
                "from {:.12g} s to {:.12g} s, wanted `gyro_offset` for a clock that differs so much, as align finds it",
                first, last, poses.front(), poses.back()));
}

bool has_to_count_turns(const GyroPlan& plan) {
  if (plan.recording.size() < 2 || plan.gyro.times.size() < 2) return false;
  const SeenPoses poses = poses_of(plan, 1.0);
  const CountedRates all = all_rates(plan.gyro);
  if (!counts_turns(poses, plan.gyro, all)) return false;
  return !are_motion(poses) || counted_turns(poses, plan.gyro, all, plan.options.gyro_offset.value_or(0.0));
}

Expected<GyroFit> fit_with_counted_turns(const GyroPlan& plan) {
  const double offset = plan.options.gyro_offset.value_or(0.0), gyro_noise = gyro_noise_of(plan);
  SeenPoses poses = poses_of(plan, 1.0);
  const CountedRates all = all_rates(plan.gyro);
  const auto count = counted_turns(poses, plan.gyro, all, offset);
  if (!count) return tl::unexpected(count.error());
  poses.noise = plan.options.noise.value_or(count->noise);
  Calibrated gyro{.rates = plan.gyro,
                  .alignment = {.offset = offset, .correction = count->correction},
                  .counts = all,
                  .rate_noise = gyro_noise,
                  .noises = {}};
  if (plan.options.gyro_bias == GyroBias::drifting) {
    GyroModelPlan near = model_plan(plan, poses, gyro.alignment);
    near.finds_trend = false;  // it would not be taken off the rates
    gyro.noises.drift = gyro_model(poses, plan.gyro, all, near).noises.drift;
  }
  const SmoothingObjective objective{.penalty = plan.options.penalty.value_or(Penalty::acceleration),
                                     .work = &plan.work};
  return fitted(plan, poses, gyro, objective, {}).map([&plan](GyroFit fit) {
    fit.finding.used = true;
    fit.residual_noise = fit.noise;
    if (plan.options.sigma) fit.sigmas = posterior_of(fit);
    return fit;
  });
}

Expected<GyroFit> fit_with_gyro(const GyroPlan& given, const SmoothingSearch& without, double noise) {
  SeenPoses poses = seen_by(given, without, given.options.noise.value_or(std::max(least_noise, noise)));
  if (auto means = check_frame(poses, given.gyro); !means) return tl::unexpected(std::move(means.error()));
  RepairedGyro repaired(given.gyro, poses);
  const GyroPlan plan{given.recording, repaired.rates, given.options, given.work};
  const double gyro_noise = gyro_noise_of(plan), interval = median_interval(plan.gyro.times);
  Seen seen = seen_gyro(plan, poses, gyro_noise);
  std::vector<GyroFinding::ClockJump> jumps;
  if (plan.gyro.clock == GyroRates::Clock::own && !repaired.has_dead_axis())
    jumps = close_jumps(repaired.rates, poses, seen.counts, seen.alignment, gyro_noise * std::sqrt(interval));
  if (!jumps.empty()) seen = seen_gyro(plan, poses, gyro_noise);
  if (auto means = check_meaning(poses, plan.gyro, seen.counts, seen.alignment.offset); !means)
    return tl::unexpected(std::move(means.error()));
  const GyroModel model = repaired.has_dead_axis()
                              ? uncalibrated(poses, seen.alignment, gyro_noise * std::sqrt(interval))
                              : gyro_model(poses, plan.gyro, seen.counts, model_plan(plan, poses, seen.alignment));
  const GyroRates rates = calibrated(plan.gyro, model.calibration);
  poses.noise = model.noises.pose();
  const double offset_sigma = model.sigmas[calibration_columns::offset];
  auto fit = fitted(plan, poses,
                    {.rates = rates,
                     .alignment = {.offset = model.calibration.offset,
                                   .offset_sigma = offset_sigma > 0.0 ? offset_sigma : seen.alignment.offset_sigma,
                                   .correction = model.calibration.correction},
                     .counts = seen.counts,
                     .rate_noise = model.noises.rate / std::sqrt(interval),
                     .noises = model.noises,
                     .dead_axes = repaired.dead_axes},
                    without.objective(), lambda_alone(without, poses.noise));
  if (!fit && fit.error().code == ErrorCode::not_converged) {  // they contradict each other
    GyroFit none;
    none.finding.doubt = GyroFinding::Doubt::rates;
    none.finding.risk = {.with = std::numeric_limits<double>::infinity(), .without = error_alone(without, noise)};
    return none;
  }
  if (!fit) return fit;
  tell(model, repaired.mount, fit->finding);
  fit->finding.clock_jumps = std::move(jumps);
  fit->finding.came_in_batches = repaired.came_in_batches;
  fit->finding.unwound_axes = repaired.unwound_axes;
  fit->finding.dead_axes = repaired.dead_axes;
  judge(*fit, model, without, std::max(least_noise, noise), gyro_noise * std::sqrt(interval));
  if (fit->finding.used) return fit;
  if (auto means = check_meaning(poses, plan.gyro, seen.counts, 0.0); !means)
    return tl::unexpected(std::move(means.error()));
  return fit;
}

}}  // namespace orispline
