// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_outliers.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_trace.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double least_share_left = 1e-6;  // 1 - h, below which rounding decides
constexpr double agreement = 3.5;          // of neighbours; of normal ones 7 in a thousand are farther
constexpr double prominence = 5.0;         // of an outlier over neighbours that do not agree
constexpr std::size_t neighbours = 2;      // on either side
constexpr int levels = 4;                  // of prominence over each other

/// From the node to its sample.
double distance_at(const SmoothingProblem& problem, const SmoothedNodes& nodes, std::size_t i) {
  if (!problem.positions.empty()) return (problem.positions[i] - nodes.positions[i]).norm();
  return shortest_increment(nodes.orientations[i], problem.orientations[i]).norm();
}

/// A sample without which the rest was fitted: its distance from what they predict, and the standard deviation of
/// that in units of the noise; both 0 where rounding decides.
struct LeftOut {
  double distance = 0.0, spread = 0.0;
};

std::vector<LeftOut> left_out(const SmoothingProblem& problem, const SmoothingFit& fit,
                              const SmoothingObjective& objective) {
  std::vector<double> weights = problem.weights;
  double usual = 0.0;  // weight of a usual sample
  for (std::size_t i = 0; i < weights.size(); ++i) {
    usual = std::max(usual, weights[i] / problem.share(i));
    weights[i] *= fit.loss_weights[i];
  }
  const auto variances = node_variances({.times = problem.times,
                                         .weights = weights,
                                         .penalty = objective.penalty,
                                         .lambda = objective.lambda,
                                         .relative_lambdas = problem.relative_lambdas});
  std::vector<LeftOut> all(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double left = 1.0 - weights[i] * variances[i];  // 1 - h
    if (!(left > least_share_left)) continue;
    const double share = problem.share(i);
    all[i] = {distance_at(problem, fit.nodes, i) / left,
              std::sqrt(1.0 + usual * share * variances[i] / left) / std::sqrt(share)};
  }
  return all;
}

/// Samples of one stretch, by their number in it.
class Judge {
 public:
  Judge(const std::vector<double>& errors, const std::vector<bool>& left_out) : errors_(errors), left_out_(left_out) {}

  [[nodiscard]] bool is_outlier(std::size_t sample) const {
    const double error = errors_[sample];
    const auto before = largest_beside(sample, -1), after = largest_beside(sample, 1);
    return error > far_threshold && before && after &&
           std::max(*before, *after) <= std::max(agreement, error / prominence);
  }

 private:
  /// Of the nearest samples that count, on one side; nothing where there are none.
  [[nodiscard]] std::optional<double> largest_beside(std::size_t sample, std::ptrdiff_t direction) const {
    const auto size = static_cast<std::ptrdiff_t>(errors_.size());
    double largest = 0.0;
    std::size_t found = 0;
    for (auto k = static_cast<std::ptrdiff_t>(sample) + direction; k >= 0 && k < size && found < neighbours;
         k += direction) {
      const auto i = static_cast<std::size_t>(k);
      if (left_out_[i]) continue;
      ++found;
      largest = std::max(largest, errors_[i]);
    }
    return found > 0 ? std::optional(largest) : std::nullopt;
  }

  const std::vector<double>& errors_;
  const std::vector<bool>& left_out_;
};

}  // namespace

std::vector<std::vector<double>> prediction_errors(const StretchProblems& problems, const StretchFits& fits,
                                                   const SmoothingObjective& objective, double noise) {
  std::vector<std::vector<double>> errors;
  for (std::size_t k = 0; k < problems.size(); ++k) {
    auto& those = errors.emplace_back();
    for (const auto& [distance, spread] : left_out(problems[k], fits.fits[k], objective))
      those.push_back(spread > 0.0 ? distance / (noise * spread) : 0.0);
  }
  return errors;
}

std::vector<std::vector<double>> left_out_errors(const StretchProblems& problems, const StretchFits& fits,
                                                 const SmoothingObjective& objective) {
  std::vector<std::vector<double>> errors;
  for (std::size_t k = 0; k < problems.size(); ++k) {
    auto& those = errors.emplace_back();
    for (const LeftOut& one : left_out(problems[k], fits.fits[k], objective)) those.push_back(one.distance);
  }
  return errors;
}

FarSamples far_candidates(const std::vector<std::vector<double>>& errors, const std::vector<Stretch>& stretches) {
  FarSamples far = far_samples(errors, stretches, far_threshold);
  double threshold = far_threshold;
  for (int level = 0; level < levels && !far.in_runs.empty(); ++level) {
    threshold *= prominence;
    for (const std::size_t sample : far_samples(errors, stretches, threshold).single)
      if (const auto found = std::ranges::lower_bound(far.in_runs, sample);
          found != far.in_runs.end() && *found == sample) {
        far.in_runs.erase(found);
        far.single.push_back(sample);
      }
  }
  std::ranges::sort(far.single);
  return far;
}

FarSamples judged(const FarSamples& far, const std::vector<std::vector<double>>& errors,
                  const std::vector<Stretch>& stretches) {
  FarSamples verdict{.single = {}, .in_runs = far.in_runs};
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const auto& [first, count] = stretches[k];
    std::vector<bool> left_out(count, false);
    for (const std::size_t sample : far.single)
      if (sample >= first && sample < first + count) left_out[sample - first] = true;
    const Judge judge(errors[k], left_out);
    for (std::size_t i = 0; i < count; ++i)
      if (left_out[i]) (judge.is_outlier(i) ? verdict.single : verdict.in_runs).push_back(first + i);
  }
  std::ranges::sort(verdict.in_runs);
  return verdict;
}

}}  // namespace orispline
