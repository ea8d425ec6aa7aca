// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/correlated_fit.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double white_share = 0.03;  // of σ: white noise beside that which correlates, for the condition of the fit
constexpr std::size_t longest_lag = 8;
constexpr double share_of_recording = 0.25;  // over which noise may correlate

/// As if all samples that count had the weight of white noise of that share of σ.
void reweigh(StretchProblems& problems, double sigma) {
  for (SmoothingProblem& problem : problems)
    for (double& weight : problem.weights)
      if (weight > 0.0) weight = 1.0 / (white_share * white_share * sigma * sigma);
}

/// By how much σ is too small, by the cost of a fit that has λ for that σ: the restricted likelihood is greatest there.
double ratio_of_noise(const CorrelatedFit& fit) {
  double cost = 0.0, count = 3.0 * static_cast<double>(observations(fit.problems));
  for (const SmoothingFit& stretch : fit.fits.fits) {
    cost += stretch.cost;
    count -= 3.0 * order_of(fit.objective.penalty);
  }
  return std::sqrt(cost / std::max(3.0, count));
}

/// For another σ and the same smoothing time.
void rescale(CorrelatedFit& fit, double ratio) {
  fit.noise *= ratio;
  fit.objective.correlated_noise *= ratio;
  fit.objective.lambda /= ratio * ratio;
  reweigh(fit.problems, fit.noise);
}

}  // namespace

Expected<CorrelatedFit> fit_with_correlated_noise(const SmoothingSearch& white, const CorrelatedNoisePlan& plan) {
  CorrelatedFit fit{.problems = white.problems(), .objective = white.objective()};
  const SmoothingProblem& first = fit.problems.front();
  fit.noise = plan.noise.value_or(1.0 / std::sqrt(*std::ranges::max_element(first.weights)));
  reweigh(fit.problems, fit.noise);
  fit.objective.correlated_noise = fit.noise;
  fit.objective.correlation_time = plan.time;
  fit.objective.finds_noise = !plan.noise;
  fit.chosen =
      chosen_lambda(fit.problems, {}, fit.objective, SmoothingCriterion::reml, fit.noise, plan.interval, std::nullopt);
  fit.objective.lambda = fit.chosen.choice.lambda;
  fit.fits = fit_stretches(fit.problems, fit.objective, {}, white.fits());
  if (fit.objective.finds_noise) rescale(fit, ratio_of_noise(fit));
  if (fit.objective.stopped()) return cancellation();
  if (!converged(fit.fits, fit.noise)) return no_end_found();
  return fit;
}

double longest_noise_time(std::span<const double> times) {
  return times.empty() ? 0.0 : share_of_recording * (times.back() - times.front());
}

Expected<void> check_noise_time(double noise_time, std::span<const double> times) {
  const double longest = longest_noise_time(times);
  if (noise_time <= longest) return {};
  return bad_option("noise_time",
                    formatted("found {:.6g} s, wanted at most {:.6g} s, a quarter of the recording, which "
                              "cannot tell slower noise from motion; state less, or record for longer",
                              noise_time, longest));
}

double most_correlated_noise(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations,
                             double time) {
  const double interval = median_interval(times);
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t lag = 1; lag <= longest_lag && 3 * lag <= times.size(); lag *= 2) {
    std::vector<double> some_times;
    std::vector<Eigen::Quaterniond> some;
    for (std::size_t i = 0; i < times.size(); i += lag) some_times.push_back(times[i]), some.push_back(orientations[i]);
    const double kept = elementary::exponential(-static_cast<double>(lag) * interval / time);
    const double share = 1.5 - 2.0 * kept + 0.5 * kept * kept;  // of σ², from the middle between two others
    most = std::min(most, local_noise(some_times, some) * std::sqrt(1.5 / share));
  }
  return most;
}

}}  // namespace orispline
