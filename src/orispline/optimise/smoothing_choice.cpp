// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/smoothing_choice.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <orispline/math/elementary.hpp>
#include <orispline/optimise/smoothing_trace.hpp>

namespace orispline::optimise {
namespace {

using elementary::natural_logarithm;

constexpr double shortest_relative_time = 0.5;   // τ over the interval, where the scan begins
constexpr double longest_relative_time = 500.0;  // beyond it the conditioning spoils the last digits
constexpr double scan_ratio = 1.3;
constexpr double steps_before = scan_ratio * scan_ratio * scan_ratio;  // in τ, where its place is known already
constexpr std::size_t rises_until_sure = 4;
constexpr SmoothingIteration scan_iteration{.tolerance = 1e-5, .most = 60};
constexpr std::size_t part_size = 2500;

double power(double base, int exponent) {
  double result = 1.0;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// -2 log of the restricted likelihood, but for a constant.
double restricted_likelihood(const StretchFits& fits, Penalty penalty, double lambda) {
  double sum = 0.0;
  for (const SmoothingFit& fit : fits.fits) {
    const auto segments = static_cast<double>(fit.residuals.size() - 1);
    sum += fit.cost + fit.log_determinant - 3.0 * order_of(penalty) * segments * natural_logarithm(lambda);
  }
  return sum;
}

double criterion_value(const Stretches& stretches, const StretchFits& fits, SmoothingCriterion criterion,
                       const SmoothingObjective& objective) {
  if (criterion == SmoothingCriterion::reml) return restricted_likelihood(fits, objective.penalty, objective.lambda);
  const double trace = hat_trace(stretches, fits, objective.penalty, objective.lambda);
  if (criterion == SmoothingCriterion::ubre) return fits.data() + 6.0 * trace;
  const auto count = static_cast<double>(observations(stretches));
  const double freedom = 1.0 - trace / count;
  return fits.data() / (3.0 * count) / (freedom * freedom);
}

/// Where the parabola through three equally spaced values has its minimum, in steps from the middle one.
double parabola_minimum(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature > 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

double longest_smoothing_time(const Stretches& stretches, double interval) {
  double span = 0.0;
  for (const SmoothingProblem& stretch : stretches) span = std::max(span, stretch.times.back() - stretch.times.front());
  return std::min(longest_relative_time * interval, span);
}

template <class T>
std::vector<T> part_of(const std::vector<T>& all, std::size_t first, std::size_t count) {
  if (all.empty()) return {};
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

double lambda_of(double smoothing_time, Penalty penalty, double noise, double interval) {
  return power(smoothing_time, 2 * order_of(penalty)) / (noise * noise * interval);
}

double smoothing_time_of(double lambda, Penalty penalty, double noise, double interval) {
  return std::exp(natural_logarithm(lambda * noise * noise * interval) / (2.0 * order_of(penalty)));
}

double StretchFits::data() const noexcept {
  return std::accumulate(fits.begin(), fits.end(), 0.0, [](double sum, const SmoothingFit& f) { return sum + f.data; });
}

StretchFits fit_stretches(const Stretches& stretches, const SmoothingObjective& objective,
                          const SmoothingIteration& iteration, const StretchFits* start) {
  StretchFits result;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    result.fits.push_back(fit_smoothing(stretches[i], objective, iteration, start ? &start->fits[i].nodes : nullptr));
  return result;
}

std::size_t observations(const Stretches& stretches) {
  std::size_t count = 0;
  for (const SmoothingProblem& stretch : stretches)
    count += static_cast<std::size_t>(std::ranges::count_if(stretch.weights, [](double w) { return w > 0.0; }));
  return count;
}

double hat_trace(const Stretches& stretches, const StretchFits& fits, Penalty penalty, double lambda) {
  double sum = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    std::vector<double> weights = stretches[i].weights;
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] *= fits.fits[i].loss_weights[k];
    sum += hat_trace(stretches[i].times, weights, penalty, lambda);
  }
  return sum;
}

LambdaChoice chosen_lambda(const Stretches& stretches, SmoothingObjective objective, SmoothingCriterion criterion,
                           double noise, double interval, std::optional<double> near) {
  const double longest = longest_smoothing_time(stretches, interval), shortest = shortest_relative_time * interval;
  const double begin = near ? std::max(shortest, *near / steps_before) : shortest;
  std::vector<double> times, values;
  StretchFits fits;
  std::size_t least = 0;
  for (double time = begin; time <= longest || times.empty(); time *= scan_ratio) {
    objective.lambda = lambda_of(time, objective.penalty, noise, interval);
    fits = fit_stretches(stretches, objective, scan_iteration, times.empty() ? nullptr : &fits);
    times.push_back(time);
    values.push_back(criterion_value(stretches, fits, criterion, objective));
    if (values.back() < values[least]) least = values.size() - 1;
    if (values.size() - 1 - least >= rises_until_sure) break;
  }
  if (least == 0 && begin > shortest) return chosen_lambda(stretches, objective, criterion, noise, interval);
  double time = times[least];
  LambdaChoice choice{.tried = times.size()};
  if (least == 0) choice.edge = LambdaChoice::Edge::shortest;
  else if (least + 1 == times.size()) choice.edge = LambdaChoice::Edge::longest;
  else
    time *=
        std::exp(natural_logarithm(scan_ratio) * parabola_minimum(values[least - 1], values[least], values[least + 1]));
  choice.lambda = lambda_of(time, objective.penalty, noise, interval);
  return choice;
}

Stretches representative_parts(const Stretches& stretches, std::size_t most) {
  std::size_t all = 0;
  for (const SmoothingProblem& stretch : stretches) all += stretch.size();
  if (all <= most) return stretches;
  Stretches parts;
  for (const SmoothingProblem& stretch : stretches) {
    const std::size_t share = most * stretch.size() / all;  // of the times
    const std::size_t count = std::max<std::size_t>(1, share / part_size);
    const std::size_t size = std::min(stretch.size(), std::max<std::size_t>(share / count, 100));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t first = count == 1 ? (stretch.size() - size) / 2 : k * (stretch.size() - size) / (count - 1);
      parts.push_back({.times = part_of(stretch.times, first, size),
                       .orientations = part_of(stretch.orientations, first, size),
                       .weights = part_of(stretch.weights, first, size),
                       .gyro = part_of(stretch.gyro, first, size),
                       .gyro_weights = part_of(stretch.gyro_weights, first, size)});
    }
  }
  return parts;
}

}  // namespace orispline::optimise
