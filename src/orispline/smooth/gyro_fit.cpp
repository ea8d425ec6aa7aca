// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_fit.hpp>

#include <algorithm>
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
#include <orispline/smooth/smoothing_trace.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_rounds = 3;       // of looking for faults beside an alignment, and of aligning without them
constexpr double sure_offset = 3.0;  // in its standard deviations: a smaller one is none
constexpr double doubt = 1.5;        // in standard deviations of the difference between two risks
constexpr double harmless_error = 4.0 * least_noise;  // [rad]: of numbers in single precision
constexpr std::size_t fewest_rates = 3;
constexpr double least_drift = 1e-3;  // over the recording, in units of the noise of the gyro
constexpr double drift_ratio = 2.0, drift_tolerance = 1e-2;
constexpr int drift_rises_until_sure = 4;
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
  GyroNoises noises{};
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

/// Where the gyro says nothing, the motion is as stiff as the orientations alone want it: `alone` is their λ, in units
/// of the weights of the fit.
void stiffen(SmoothingProblem& problem, const std::vector<bool>& unled, double lambda, double alone) {
  if (std::ranges::find(unled, true) == unled.end()) return;
  for (const bool is_unled : unled) problem.relative_lambdas.push_back(is_unled ? alone / lambda : 1.0);
}

/// Whether the rates, whose clock is corrected, begin late or end early.
bool leaves_out_an_end(const std::vector<bool>& unled) {
  constexpr std::ptrdiff_t fewest = 3;  // intervals
  const auto first = std::ranges::find(unled, false);
  const auto last = std::find(unled.rbegin(), unled.rend(), false);
  return first - unled.begin() >= fewest || last - unled.rbegin() >= fewest;
}

/// The λ of the jerk's penalty with the smoothing time of one of the acceleration's.
double lambda_of_jerk(double of_acceleration, const SeenPoses& poses) {
  const double interval = median_interval(poses.times);
  return lambda_of(smoothing_time_of(of_acceleration, Penalty::acceleration, poses.noise, interval), Penalty::jerk,
                   poses.noise, interval);
}

/// The smoothing time that the changes of the rates suggest, of a penalty of the acceleration: between two of them it is
/// white by their σ. Absent where they are noise, or jump.
std::optional<double> time_of_rates(const GyroFit& fit, Penalty penalty) {
  const SmoothingProblem& problem = fit.problems.front();
  double squares = 0.0, count = 0.0, time = 0.0;
  for (std::size_t i = 0; i + 1 < problem.size(); ++i) {
    if (problem.gyro_weights[i] == 0.0 || problem.gyro_weights[i + 1] == 0.0) continue;
    squares += (problem.gyro[i + 1] - problem.gyro[i]).squaredNorm() / 3.0 - 2.0 * fit.finding.noise * fit.finding.noise;
    time += problem.times[i + 1] - problem.times[i];
    count += 1.0;
  }
  if (count == 0.0 || !(squares > 0.0)) return std::nullopt;
  const double shortest = 0.2 * fit.interval, longest = 200.0 * fit.interval;
  const double tau = smoothing_time_of(time / squares, Penalty::acceleration, fit.noise, fit.interval);
  return penalty == Penalty::acceleration ? std::optional(std::clamp(tau, shortest, longest)) : std::nullopt;
}

/// λ by the restricted likelihood; what the fit with it may begin with is returned.
StretchFits choose_lambda(GyroFit& result, const StretchFits& start, SmoothingObjective& objective) {
  ChosenLambda chosen = chosen_lambda(result.problems, start, objective, SmoothingCriterion::reml, result.noise,
                                      result.interval, time_of_rates(result, objective.penalty));
  objective.lambda = chosen.choice.lambda;
  StretchFits near = std::exchange(chosen.fits, {});
  result.chosen = std::move(chosen);
  return near.fits.empty() ? start : near;
}

/// How much the bias drifts, by the same likelihood: from hardly at all upward, until it falls for some time.
StretchFits choose_drift(GyroFit& result, const StretchFits& start, SmoothingObjective& objective, double gyro_noise) {
  const StretchProblems parts = representative_parts(result.problems, most_times_for_choice);
  const bool is_all = parts.front().size() == result.problems.front().size();
  const double span = parts.front().times.back() - parts.front().times.front();
  objective.bias = SmoothingObjective::Bias::drifting;
  StretchFits fits = is_all ? start : StretchFits{}, best;
  double least = std::numeric_limits<double>::infinity(), found = 0.0;
  objective.drift = least_drift * gyro_noise / std::sqrt(span);
  for (int rises = 0; rises < drift_rises_until_sure && !objective.stopped(); objective.drift *= drift_ratio) {
    fits = fit_stretches(parts, objective, {.tolerance = drift_tolerance * result.noise}, fits);
    const double value = criterion_value(parts, fits, SmoothingCriterion::reml, objective);
    rises = value < least ? 0 : rises + 1;
    if (!(value < least)) continue;
    least = value;
    found = objective.drift;
    best = fits;
  }
  objective.drift = found;
  result.finding.drift = found;
  return is_all ? best : start;
}

/// λ as stated or by the restricted likelihood, and the fit with it. `alone`: λ of the orientations by themselves.
Expected<GyroFit> fitted(const GyroPlan& plan, const SeenPoses& poses, const Seen& seen, double gyro_noise,
                         SmoothingObjective objective, std::optional<double> alone) {
  GyroRows rows = rows_of(poses, plan.gyro, seen.counts, gyro_noise, seen.alignment);
  GyroFit result;
  result.noise = poses.noise;
  result.places = std::move(rows.places);
  result.rates = std::move(rows.rates);
  result.interval = median_interval(rows.problem.times);
  result.finding = {.noise = gyro_noise, .offset = seen.alignment.offset, .offset_sigma = seen.alignment.offset_sigma};
  for (std::size_t k = 0; k < seen.counts.size(); ++k)
    if (!seen.counts[k]) result.finding.rejected.push_back(k);
  result.problems.push_back(std::move(rows.problem));
  StretchFits start{{{.nodes = std::move(rows.start)}}};
  objective.bias = SmoothingObjective::Bias::constant;
  if (alone && !plan.options.penalty && !plan.options.smoothing_time && leaves_out_an_end(rows.unled)) {
    // Else the acceleration would be zero at that end, though the rates have told it up to there.
    objective.penalty = Penalty::jerk;
    alone = lambda_of_jerk(*alone, poses);
  }
  if (plan.options.smoothing_time)
    objective.lambda = lambda_of(*plan.options.smoothing_time, objective.penalty, poses.noise, result.interval);
  else start = choose_lambda(result, start, objective);
  if (seen.noises.drift > 0.0 || seen.noises.correlated > 0.0) {
    const double span = result.problems.front().times.back() - result.problems.front().times.front();
    objective.bias = SmoothingObjective::Bias::drifting;
    objective.drift = std::max(seen.noises.drift, least_drift * gyro_noise / std::sqrt(span));
    if (seen.noises.drift > 0.0) result.finding.drift = seen.noises.drift;
  } else if (plan.options.gyro_bias == GyroBias::drifting) {
    start = choose_drift(result, start, objective, gyro_noise);
    if (!plan.options.smoothing_time) start = choose_lambda(result, start, objective);
  }
  if (seen.noises.correlated > 0.0) {
    // λ was chosen as if all of the noise were white: beside one that keeps, a motion that follows it is as likely.
    objective.kept_noise = seen.noises.correlated;
    objective.noise_time = seen.noises.time;
    const double share = poses.noise / seen.noises.white;
    for (double& weight : result.problems.front().weights) weight *= share * share;
  }
  if (alone && result.chosen) stiffen(result.problems.front(), rows.unled, objective.lambda, *alone);
  result.fits = fit_stretches(result.problems, objective, {}, start);
  result.objective = objective;
  if (objective.stopped()) return cancellation();
  if (!converged(result.fits, poses.noise)) return no_end_found();
  return result;
}

/// What the orientations of a fit are expected to be wrong by, as a sum of squares in units of σ², which the risk
/// estimate knows whatever the gyro did: the residuals and twice the freedom that the orientations themselves had.
struct Risk {
  double squares, trace;

  [[nodiscard]] double expected(double observations) const { return squares + 6.0 * trace - 3.0 * observations; }
};

double squares_of(const SmoothingProblem& problem, const SmoothingFit& fit, double noise) {
  double sum = 0.0;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem.weights[i] > 0.0) sum += problem.share(i) * fit.residuals[i].squaredNorm();
  return sum / (noise * noise);
}

double trace_with_gyro(const GyroFit& fit) {
  const SmoothingProblem& problem = fit.problems.front();
  const std::vector<double> weights = weights_left(problem, fit.fits.fits.front());
  const std::vector<double> variances = node_variances({.times = problem.times,
                                                        .weights = weights,
                                                        .penalty = fit.objective.penalty,
                                                        .lambda = fit.objective.lambda,
                                                        .relative_lambdas = problem.relative_lambdas,
                                                        .rate_weights = problem.gyro_weights,
                                                        .drift = fit.objective.drift});
  double trace = fit.objective.drift > 0.0 ? 0.0 : 1.0;  // a constant bias is no unknown there
  for (std::size_t i = 0; i < weights.size(); ++i) trace += weights[i] * variances[i];
  return trace;
}

void judge(GyroFit& fit, const SmoothingSearch& without, double noise) {
  const auto count = static_cast<double>(observations(fit.problems));
  const Risk with{squares_of(fit.problems.front(), fit.fits.fits.front(), noise), trace_with_gyro(fit)};
  const Risk alone{squares_of(without.problems().front(), without.fits().fits.front(), noise), without.freedom().trace};
  const double margin = doubt * 2.0 * std::sqrt(3.0 * alone.trace);
  const auto error = [&](const Risk& risk) { return noise * std::sqrt(std::max(0.0, risk.expected(count)) / count); };
  fit.finding.risk = {.with = error(with), .without = error(alone)};
  const bool is_harmless = noise * noise * with.expected(count) <= harmless_error * harmless_error * count;
  fit.finding.used = is_harmless || with.expected(count) + margin <= alone.expected(count);
  fit.residual_noise = noise * std::sqrt(with.squares / (3.0 * std::max(1.0, count - with.trace)));
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
  const double offset = plan.options.gyro_offset.value_or(0.0);
  SeenPoses poses = poses_of(plan, 1.0);
  const Seen all{{.offset = offset}, all_rates(plan.gyro)};
  const auto count = counted_turns(poses, plan.gyro, all.counts, offset);
  if (!count) return tl::unexpected(count.error());
  poses.noise = plan.options.noise.value_or(count->noise);
  Seen seen = all;
  seen.alignment.correction = count->correction;
  const SmoothingObjective objective{.penalty = plan.options.penalty.value_or(Penalty::acceleration),
                                     .work = &plan.work};
  return fitted(plan, poses, seen, gyro_noise_of(plan), objective, {}).map([](GyroFit fit) {
    fit.finding.used = true;
    fit.residual_noise = fit.noise;
    return fit;
  });
}

Expected<GyroFit> fit_with_gyro(const GyroPlan& plan, const SmoothingSearch& without, double noise) {
  SeenPoses poses = seen_by(plan, without, plan.options.noise.value_or(std::max(least_noise, noise)));
  if (auto means = check_frame(poses, plan.gyro); !means) return tl::unexpected(std::move(means.error()));
  const double gyro_noise = gyro_noise_of(plan);
  Seen seen = seen_gyro(plan, poses, gyro_noise);
  if (auto means = check_meaning(poses, plan.gyro, seen.counts, seen.alignment.offset); !means)
    return tl::unexpected(std::move(means.error()));
  // A usual sample that counts has the weight that λ of the orientations alone stands beside.
  const SmoothingProblem& problem = without.problems().front();
  double weight = 0.0;
  for (std::size_t i = 0; i < problem.size(); ++i) weight = std::max(weight, problem.weights[i] / problem.share(i));
  const double alone = without.lambda() / (weight * poses.noise * poses.noise);
  const double gyro_interval = median_interval(plan.gyro.times);
  const GyroModel model =
      gyro_model(poses, plan.gyro, seen.counts,
                 {.near = {.correction = seen.alignment.correction, .offset = seen.alignment.offset},
                  .rate_noise = gyro_noise * std::sqrt(gyro_interval),
                  .pose_noise = poses.noise,
                  .finds_offset = !plan.options.gyro_offset,
                  .finds_clock_rate = plan.gyro.clock == GyroRates::Clock::own,
                  .states_noise = plan.options.noise.has_value()});
  const GyroRates rates = calibrated(plan.gyro, model.calibration);
  const GyroPlan calibrated_plan{plan.recording, rates, plan.options, plan.work};
  seen.alignment.offset = model.calibration.offset;
  seen.alignment.correction = model.calibration.correction;
  seen.noises = model.noises;
  poses.noise = std::hypot(model.noises.white, model.noises.correlated);
  auto fit = fitted(calibrated_plan, poses, seen, model.noises.rate / std::sqrt(gyro_interval),
                    without.objective(), alone);
  if (!fit) return fit;
  judge(*fit, without, std::max(least_noise, noise));
  {
    const NodeSigmas sigmas = node_sigmas(fit->problems.front(), fit->objective, fit->fits.fits.front().nodes);
    double sum = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < fit->places.size(); ++i) {
      sum += sigmas.orientations[fit->places[i]].squaredNorm();
      const double d = angular_distance(fit->fits.fits.front().nodes.orientations[fit->places[i]], without.fits().fits.front().nodes.orientations[i]);
      apart += d * d;
    }
    const double n = static_cast<double>(fit->places.size());
    const double with = std::sqrt(sum / n), apart_with = std::sqrt((apart + sum) / n);
    const double own = noise * std::sqrt(3.0 * without.freedom().trace / without.freedom().observations);
    const bool explained = 2 * model.seen > poses.times.size() && model.noises.clock == 0.0 && model.noises.rate < 3.0 * gyro_noise * std::sqrt(gyro_interval) && with < 0.6 * apart_with;
    if (getenv("GYRO_DEBUG")) fprintf(stderr, "before %d %.4g %.4g own %.4g diff %.4g explained %d\n", fit->finding.used, fit->finding.risk->with*57.3, fit->finding.risk->without*57.3, own*57.3, apart_with*57.3, explained);
    fit->finding.used = explained || (with < own && model.noises.clock == 0.0);
    fit->finding.risk = {.with = with, .without = fit->finding.used ? apart_with : own};
  }
  if (getenv("GYRO_FORCE")) fit->finding.used = true;
  if (fit->finding.used) return fit;
  if (auto means = check_meaning(poses, plan.gyro, seen.counts, 0.0); !means)
    return tl::unexpected(std::move(means.error()));
  return fit;
}

}}  // namespace orispline
