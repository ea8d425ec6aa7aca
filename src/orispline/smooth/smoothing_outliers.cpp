// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_outliers.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
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
constexpr double like_it = 3.0;            // times nearer is still the like of a sample
constexpr double same_level = 1.02;        // of distances that are counted together
constexpr std::size_t usual_singles = 2;   // single samples for each place where the motion is as far

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

/// A far sample and its error.
struct Far {
  std::size_t sample;
  double error;
};

std::vector<Far> with_errors(const std::vector<std::size_t>& samples, const std::vector<std::vector<double>>& errors,
                             const std::vector<Stretch>& stretches) {
  std::vector<Far> far;
  std::size_t k = 0;
  for (const std::size_t sample : samples) {
    while (sample >= stretches[k].first + stretches[k].count) ++k;
    far.push_back({sample, errors[k][sample - stretches[k].first]});
  }
  return far;
}

/// In how many places some are beyond a level; neighbours are in one place.
std::size_t places_beyond(double level, const std::vector<Far>& far) {
  std::size_t places = 0;
  std::optional<std::size_t> before;
  for (const auto& [sample, error] : far) {
    if (error < level) continue;
    if (!before || sample - *before > neighbours) ++places;
    before = sample;
  }
  return places;
}

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

FarSamples outstanding(const FarSamples& far, const std::vector<std::size_t>& motion,
                       const std::vector<std::vector<double>>& errors, const std::vector<Stretch>& stretches) {
  std::vector<std::size_t> samples_of_motion;
  std::ranges::set_union(far.in_runs, motion, std::back_inserter(samples_of_motion));
  std::erase_if(samples_of_motion, [&](std::size_t i) { return std::ranges::binary_search(far.single, i); });
  const std::vector<Far> single = with_errors(far.single, errors, stretches),
                         moving = with_errors(samples_of_motion, errors, stretches);
  std::vector<Far> by_error = single;
  std::ranges::sort(by_error, {}, &Far::error);
  FarSamples verdict{.single = {}, .in_runs = far.in_runs};
  double level = 0.0;
  bool is_motion = false;
  for (const auto& [sample, error] : by_error) {
    if (const double wanted = std::max(agreement, error / like_it); wanted > same_level * level) {
      level = wanted;
      is_motion = usual_singles * places_beyond(level, moving) > places_beyond(level, single);
    }
    (is_motion ? verdict.in_runs : verdict.single).push_back(sample);
  }
  std::ranges::sort(verdict.single);
  std::ranges::sort(verdict.in_runs);
  return verdict;
}

}}  // namespace orispline
