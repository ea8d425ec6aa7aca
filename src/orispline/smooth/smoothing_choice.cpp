// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_choice.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <orispline/math/number.hpp>
#include <orispline/smooth/smoothing_trace.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using elementary::exponential, elementary::natural_logarithm;

constexpr double first_relative_time = 0.5;      // τ over the interval, where the scan begins
constexpr double shortest_relative_time = 0.1;   // which leaves 0.99 of what changes from sample to sample
constexpr double longest_relative_time = 500.0;  // beyond it the conditioning spoils the last digits
constexpr double scan_ratio = 1.3;
constexpr int coarse_step = 2, rises_until_sure = 2;  // in steps of the ratio; in coarse steps
constexpr int most_scan_iterations = 20;
constexpr double scan_tolerance = 1e-3, tolerance_upward = 1e-2;  // of the iteration, in units of the noise
constexpr double least_scan_tolerance = 1e-9;                     // [rad]

constexpr double most_noise_foreseen = 0.2;  // [rad], with more the minima are many
constexpr std::size_t part_size = 2500;
constexpr std::size_t most_times_upward = 2500, part_size_upward = 625;

double power(double base, int exponent) {
  double result = 1.0;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// -2 log of the restricted likelihood, but for a constant.
double restricted_likelihood(const StretchProblems& stretches, const StretchFits& fits,
                             const SmoothingObjective& objective) {
  double sum = 0.0, cost = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto segments = static_cast<double>(stretches[i].size() - 1);
    cost += fits.fits[i].cost;
    sum += fits.fits[i].cost + log_determinant(stretches[i], objective, fits.fits[i].nodes) -
           3.0 * order_of(objective.penalty) * segments * natural_logarithm(objective.lambda);
    if (objective.bias == SmoothingObjective::Bias::drifting)
      sum += 6.0 * segments * natural_logarithm(objective.drift);
  }
  if (!objective.finds_noise) return sum;
  const double of_lines = 3.0 * order_of(objective.penalty) * static_cast<double>(stretches.size());
  const double freedom = std::max(3.0, 3.0 * static_cast<double>(observations(stretches)) - of_lines);
  return sum - cost + freedom * natural_logarithm(cost);
}

/// Where the parabola through three equally spaced values has its minimum, in steps from the middle one.
double parabola_minimum(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature > 0.0 && std::isfinite(curvature) ? 0.5 * (before - after) / curvature : 0.0;
}

/// The criterion at τ = τ₀ ratio^k, each value found once.
class Scan {
 public:
  Scan(const StretchProblems& stretches, const StretchFits& start, SmoothingObjective objective,
       SmoothingCriterion criterion, double noise, double interval, double origin, double tolerance)
      : stretches_(stretches),
        start_(start),
        objective_(objective),
        criterion_(criterion),
        noise_(noise),
        interval_(interval),
        origin_(origin),
        tolerance_(std::max(tolerance * noise, least_scan_tolerance)),
        shortest_(shortest_relative_time * interval),
        longest_(longest_smoothing_time(stretches, interval)) {}

  /// Where the least value is, upward until the criterion has risen for some time.
  [[nodiscard]] int from_below() {
    int least = 0;
    for (int k = 0; k - least <= rises_until_sure * coarse_step && inside(k) && !objective_.stopped(); k += coarse_step)
      if (value(k) < value(least)) least = k;
    return least;
  }

  /// Down to the least value next to k, and by a parabola between the steps.
  [[nodiscard]] ChosenLambda around(int k) {
    while (!objective_.stopped()) {
      if (inside(k - 1) && value(k - 1) < value(k)) --k;
      else if (inside(k + 1) && value(k + 1) < value(k)) ++k;
      else break;
    }
    ChosenLambda chosen;
    double time = time_at(k);
    if (!inside(k - 1)) chosen.choice.edge = LambdaChoice::Edge::shortest;
    else if (!inside(k + 1)) chosen.choice.edge = LambdaChoice::Edge::longest;
    else if (!objective_.stopped())
      time *= exponential(natural_logarithm(scan_ratio) * parabola_minimum(value(k - 1), value(k), value(k + 1)));
    chosen.choice.lambda = lambda(time);
    chosen.fits = nearest_fits(k);
    return chosen;
  }

  [[nodiscard]] bool converges_at(int k) { return value(k) < std::numeric_limits<double>::infinity(); }

 private:
  struct Tried {
    double value;
    StretchFits fits;
  };

  [[nodiscard]] double time_at(int k) const {
    return origin_ * power(k < 0 ? 1.0 / scan_ratio : scan_ratio, std::abs(k));
  }
  [[nodiscard]] double lambda(double time) const { return lambda_of(time, objective_.penalty, noise_, interval_); }
  [[nodiscard]] bool inside(int k) const { return k == 0 || (time_at(k) >= shortest_ && time_at(k) <= longest_); }

  double value(int k) {
    if (const auto known = tried_.find(k); known != tried_.end()) return known->second.value;
    objective_.lambda = lambda(time_at(k));
    const SmoothingIteration iteration{
        .tolerance = tolerance_, .most = most_scan_iterations, .foresees = noise_ < most_noise_foreseen};
    StretchFits fits = fit_stretches(stretches_, objective_, iteration, nearest_fits(k));
    const double value = converged(fits, noise_) ? criterion_value(stretches_, fits, criterion_, objective_)
                                                 : std::numeric_limits<double>::infinity();
    tried_.emplace(k, Tried{value, std::move(fits)});
    return value;
  }

  [[nodiscard]] const StretchFits& nearest_fits(int k) const {
    const auto nearest =
        std::ranges::min_element(tried_, {}, [k](const auto& tried) { return std::abs(tried.first - k); });
    return nearest == tried_.end() ? start_ : nearest->second.fits;
  }

  const StretchProblems& stretches_;
  const StretchFits& start_;
  SmoothingObjective objective_;
  SmoothingCriterion criterion_;
  double noise_, interval_, origin_, tolerance_, shortest_, longest_;
  std::map<int, Tried> tried_;
};

template <class T>
std::vector<T> part_of(const std::vector<T>& all, std::size_t first, std::size_t count) {
  if (all.empty()) return {};
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

std::size_t times_of(const StretchProblems& stretches) {
  std::size_t times = 0;
  for (const SmoothingProblem& stretch : stretches) times += stretch.size();
  return times;
}

SmoothingProblem part_of(const SmoothingProblem& stretch, std::size_t first, std::size_t size) {
  return {.times = part_of(stretch.times, first, size),
          .orientations = part_of(stretch.orientations, first, size),
          .positions = part_of(stretch.positions, first, size),
          .weights = part_of(stretch.weights, first, size),
          .gyro = part_of(stretch.gyro, first, size),
          .gyro_weights = part_of(stretch.gyro_weights, first, size),
          .dead_gyro_axes = stretch.dead_gyro_axes,
          .relative_lambdas = part_of(stretch.relative_lambdas, first, size - 1)};
}

SmoothingFit part_of(const SmoothingFit& fit, std::size_t first, std::size_t size) {
  const SmoothedNodes& nodes = fit.nodes;
  return {.nodes = {.orientations = part_of(nodes.orientations, first, size),
                    .angular_velocities = part_of(nodes.angular_velocities, first, size),
                    .angular_accelerations = part_of(nodes.angular_accelerations, first, size),
                    .positions = part_of(nodes.positions, first, size),
                    .gyro_correction = nodes.gyro_correction,
                    .gyro_corrections = part_of(nodes.gyro_corrections, first, size),
                    .correlated_noises = part_of(nodes.correlated_noises, first, size)},
          .steps = fit.steps};
}

/// Of one of the stretches.
struct Part {
  std::size_t stretch, first, size;
};

/// Evenly spread, with `most` times altogether, or a little more, and about so many each; or the whole stretches.
std::vector<Part> spread_parts(const StretchProblems& stretches, std::size_t most, std::size_t each) {
  const std::size_t all = times_of(stretches);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::size_t times = stretches[i].size();
    if (all <= most) {
      parts.push_back({i, 0, times});
      continue;
    }
    const std::size_t share = most * times / all, count = std::max<std::size_t>(1, share / each);
    const std::size_t size = std::min(times, std::max<std::size_t>(share / count, 100));
    for (std::size_t k = 0; k < count; ++k)
      parts.push_back({i, count == 1 ? (times - size) / 2 : k * (times - size) / (count - 1), size});
  }
  return parts;
}

template <class T>
std::vector<T> cut(const std::vector<T>& stretches, const std::vector<Part>& parts) {
  std::vector<T> those;
  if (stretches.empty()) return those;
  for (const auto& [stretch, first, size] : parts) those.push_back(part_of(stretches[stretch], first, size));
  return those;
}

}  // namespace

double longest_smoothing_time(const StretchProblems& stretches, double interval) {
  double span = 0.0;
  for (const SmoothingProblem& stretch : stretches) span = std::max(span, stretch.times.back() - stretch.times.front());
  return std::min(longest_relative_time * interval, span);
}

double lambda_of(double smoothing_time, Penalty penalty, double noise, double interval) {
  return power(smoothing_time, 2 * order_of(penalty)) / (noise * noise * interval);
}

double smoothing_time_of(double lambda, Penalty penalty, double noise, double interval) {
  return exponential(natural_logarithm(lambda * noise * noise * interval) / (2.0 * order_of(penalty)));
}

double StretchFits::data() const noexcept {
  return std::accumulate(fits.begin(), fits.end(), 0.0, [](double sum, const SmoothingFit& f) { return sum + f.data; });
}

StretchFits fit_stretches(const StretchProblems& stretches, const SmoothingObjective& objective,
                          const SmoothingIteration& iteration, const StretchFits& start) {
  StretchFits result;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const SmoothingFit* const before = start.fits.empty() ? nullptr : &start.fits[i];
    SmoothingIteration own = iteration;
    if (before) own.steps = before->steps;
    result.fits.push_back(fit_smoothing(stretches[i], objective, own, before ? &before->nodes : nullptr));
  }
  return result;
}

NodeSigmas sigmas_of(const StretchProblems& stretches, const SmoothingObjective& objective, const StretchFits& fits) {
  NodeSigmas all;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const NodeSigmas part = node_sigmas(stretches[k], objective, fits.fits[k].nodes);
    all.orientations.insert(all.orientations.end(), part.orientations.begin(), part.orientations.end());
    all.angular_velocities.insert(all.angular_velocities.end(), part.angular_velocities.begin(),
                                  part.angular_velocities.end());
    all.to_next.insert(all.to_next.end(), part.to_next.begin(), part.to_next.end());
  }
  return all;
}

bool converged(const StretchFits& fits, double noise) {
  return std::ranges::all_of(fits.fits, [noise](const SmoothingFit& fit) { return fit.last_step <= noise; });
}

std::size_t observations(const StretchProblems& stretches) {
  std::size_t count = 0;
  for (const SmoothingProblem& stretch : stretches)
    count += static_cast<std::size_t>(std::ranges::count_if(stretch.weights, [](double w) { return w > 0.0; }));
  return count;
}

std::vector<double> weights_left(const SmoothingProblem& problem, const SmoothingFit& fit) {
  std::vector<double> weights = problem.weights;
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] *= fit.loss_weights[k];
  return weights;
}

double hat_trace(const StretchProblems& stretches, const StretchFits& fits, Penalty penalty, double lambda) {
  double sum = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::vector<double> weights = weights_left(stretches[i], fits.fits[i]);
    sum += hat_trace({.times = stretches[i].times,
                      .weights = weights,
                      .penalty = penalty,
                      .lambda = lambda,
                      .relative_lambdas = stretches[i].relative_lambdas});
  }
  return sum;
}

double criterion_value(const StretchProblems& stretches, const StretchFits& fits, SmoothingCriterion criterion,
                       const SmoothingObjective& objective) {
  if (criterion == SmoothingCriterion::reml) return restricted_likelihood(stretches, fits, objective);
  const double trace = hat_trace(stretches, fits, objective.penalty, objective.lambda);
  if (criterion == SmoothingCriterion::ubre) return fits.data() + 6.0 * trace;
  const auto count = static_cast<double>(observations(stretches));
  const double freedom = 1.0 - trace / count;
  return fits.data() / (3.0 * count) / (freedom * freedom);
}

ChosenLambda chosen_lambda(const StretchProblems& stretches, const StretchFits& start,
                           const SmoothingObjective& objective, SmoothingCriterion criterion, double noise,
                           double interval, std::optional<double> near) {
  const std::vector<Part> places = spread_parts(stretches, most_times_for_choice, part_size);
  const StretchProblems parts = cut(stretches, places);
  const StretchFits fits{cut(start.fits, places)};
  const double origin = near.value_or(first_relative_time * interval);
  Scan scan(parts, fits, objective, criterion, noise, interval, origin, scan_tolerance);
  int from = 0;
  if (!near) {
    const std::vector<Part> few = spread_parts(parts, most_times_upward, part_size_upward);
    const StretchProblems fewer = cut(parts, few);
    const StretchFits fewer_fits{cut(fits.fits, few)};
    const bool all = times_of(fewer) == times_of(parts);
    if (!all)
      from = Scan(fewer, fewer_fits, objective, criterion, noise, interval, origin, tolerance_upward).from_below();
    if (all || !scan.converges_at(from)) from = scan.from_below();
  }
  ChosenLambda chosen = scan.around(from);
  chosen.times = times_of(parts);
  if (chosen.times < times_of(stretches)) chosen.fits = {};
  return chosen;
}

StretchProblems representative_parts(const StretchProblems& stretches, std::size_t most) {
  return cut(stretches, spread_parts(stretches, most, part_size));
}

double expected_work(std::size_t samples, std::size_t most_of_choice) noexcept {
  constexpr double of_choice = 60.0, of_fits = 10.0;
  return of_choice * static_cast<double>(std::min(samples, most_of_choice)) + of_fits * static_cast<double>(samples);
}

}}  // namespace orispline
