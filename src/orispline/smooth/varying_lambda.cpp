// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/varying_lambda.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <orispline/math/number.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/smooth/smoothing_trace.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_newton_steps = 20;
constexpr double longest_newton_step = 3.0;  // of log λ, beyond which the exponential is not to be trusted
constexpr double farthest = 18.0;            // from the first value, which is a hundred times as long a τ
constexpr double newton_tolerance = 1e-4;    // of log λ
constexpr double least_newton_share = 1e-3;  // of a step
constexpr double least_diagonal = 1e-9;      // for knots about which nothing is said

/// The solution of a symmetric tridiagonal system with a positive diagonal that outweighs the rest.
std::vector<double> solved(std::vector<double> diagonal, const std::vector<double>& beside, std::vector<double> right) {
  for (std::size_t k = 1; k < diagonal.size(); ++k) {
    const double factor = beside[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * beside[k - 1];
    right[k] -= factor * right[k - 1];
  }
  for (std::size_t k = diagonal.size(); k-- > 0;) {
    if (k + 1 < diagonal.size()) right[k] -= beside[k] * right[k + 1];
    right[k] /= diagonal[k];
  }
  return right;
}

/// How much of a difference between neighbours is allowed, and by how much the criterion is to fall for it: this share
/// of what all the freedom of the curve costs, since softer ones follow the noise too.
struct Softness {
  double stiffness, gain;
};

constexpr std::array softnesses{Softness{32.0, 0.05}, Softness{8.0, 0.1}, Softness{2.0, 0.15}, Softness{0.5, 0.15}};
constexpr double least_gain = 0.01;  // that gain, over the softness before: with less, softer ones are not tried
constexpr int most_updates = 10;
constexpr double settled = 0.1;           // of log λ, in one update
constexpr double rough_tolerance = 1e-2;  // of the iteration, in units of the noise
constexpr std::size_t samples_per_knot = 3;

/// One try: λ as a curve of each stretch, and the fits with it.
class Adaptation {
 public:
  Adaptation(const StretchProblems& problems, const SmoothingObjective& objective, const StretchFits& fits,
             SmoothingCriterion criterion, double noise, double interval)
      : problems_(problems), objective_(objective), fits_(fits), criterion_(criterion), noise_(noise) {
    const double longest = longest_smoothing_time(problems, interval),
                 highest = elementary::natural_logarithm(lambda_of(longest, objective.penalty, noise, interval));
    for (std::size_t k = 0; k < problems.size(); ++k) {
      const double trace =
          hat_trace(StretchProblems{problems[k]}, StretchFits{{fits.fits[k]}}, objective.penalty, objective.lambda);
      const std::size_t most = std::max<std::size_t>(2, problems[k].size() / samples_per_knot);
      const auto knots = std::clamp(static_cast<std::size_t>(std::max(0.0, trace)), std::size_t{2}, most);
      curves_.emplace_back(problems[k].times, knots, elementary::natural_logarithm(objective.lambda), highest);
    }
  }

  /// From where the last one ended.
  void soften(double stiffness) {
    for (int update = 0; update < most_updates && !objective_.stopped(); ++update) {
      const std::vector<std::vector<double>> freedoms = freedoms_of_intervals();
      const double scale = noise_scale(freedoms);
      double change = 0.0;
      for (std::size_t k = 0; k < problems_.size(); ++k) {
        std::vector<double> energies = fits_.fits[k].interval_penalties;
        for (double& energy : energies) energy /= scale;
        change = std::max(change, curves_[k].update(energies, freedoms[k], stiffness));
      }
      take_curves();
      refit();
      if (change < settled) break;
    }
  }

  /// With the mean λ that the criterion likes best, next to this one.
  void choose_level(double near, double interval) {
    const double time = smoothing_time_of(near, objective_.penalty, noise_, interval);
    ChosenLambda chosen = chosen_lambda(problems_, fits_, objective_, criterion_, noise_, interval, time);
    objective_.lambda = chosen.choice.lambda;
    if (!chosen.fits.fits.empty()) fits_ = std::move(chosen.fits);
    refit();
  }

  [[nodiscard]] double value() const {
    return converged(fits_, noise_) ? criterion_value(problems_, fits_, criterion_, objective_)
                                    : std::numeric_limits<double>::infinity();
  }
  /// What the freedom of the curve is of all that is observed.
  [[nodiscard]] double freedom() const {
    return hat_trace(problems_, fits_, objective_.penalty, objective_.lambda) /
           static_cast<double>(observations(problems_));
  }

  [[nodiscard]] const StretchProblems& problems() const noexcept { return problems_; }
  [[nodiscard]] const StretchFits& fits() const noexcept { return fits_; }
  [[nodiscard]] double lambda() const noexcept { return objective_.lambda; }

 private:
  /// The variance of the samples over that of which their weights are. The trace of the hat matrix is the freedom of
  /// the intervals with that of a motion without penalty.
  [[nodiscard]] double noise_scale(const std::vector<std::vector<double>>& freedoms) const {
    if (criterion_ == SmoothingCriterion::ubre) return 1.0;
    auto rest = static_cast<double>(observations(problems_));
    for (const std::vector<double>& those : freedoms)
      rest -= std::accumulate(those.begin(), those.end(), 0.0) / 3.0 + order_of(objective_.penalty);
    return fits_.data() / (3.0 * std::max(rest, 1.0));
  }

  /// Of all axes, for each stretch.
  [[nodiscard]] std::vector<std::vector<double>> freedoms_of_intervals() const {
    std::vector<std::vector<double>> all;
    for (std::size_t k = 0; k < problems_.size(); ++k) {
      const std::vector<double> weights = weights_left(problems_[k], fits_.fits[k]);
      auto& freedoms = all.emplace_back(interval_freedoms({.times = problems_[k].times,
                                                           .weights = weights,
                                                           .penalty = objective_.penalty,
                                                           .lambda = objective_.lambda,
                                                           .relative_lambdas = problems_[k].relative_lambdas}));
      for (double& freedom : freedoms) freedom = 3.0 * std::max(0.0, freedom);
    }
    return all;
  }

  void take_curves() {
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < problems_.size(); ++k)
      for (std::size_t i = 0; i + 1 < problems_[k].size(); ++i, ++count) sum += curves_[k](i);
    objective_.lambda = elementary::exponential(sum / count);
    for (std::size_t k = 0; k < problems_.size(); ++k) {
      problems_[k].relative_lambdas.resize(problems_[k].size() - 1);
      for (std::size_t i = 0; i + 1 < problems_[k].size(); ++i)
        problems_[k].relative_lambdas[i] = elementary::exponential(curves_[k](i) - sum / count);
    }
  }

  void refit() {
    const SmoothingIteration iteration{.tolerance = rough_tolerance * noise_, .foresees = true};
    fits_ = fit_stretches(problems_, objective_, iteration, fits_);
  }

  StretchProblems problems_;
  SmoothingObjective objective_;
  StretchFits fits_;
  SmoothingCriterion criterion_;
  double noise_;
  std::vector<LogLambdaCurve> curves_;
};

}  // namespace

LogLambdaCurve::LogLambdaCurve(std::span<const double> times, std::size_t knots, double log_lambda, double most)
    : values_(knots, log_lambda),
      least_(log_lambda - farthest),
      most_(std::clamp(most, log_lambda, log_lambda + farthest)) {
  const auto segments = static_cast<double>(knots - 1);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double middle = 0.5 * (times[i] + times[i + 1]) - times.front();
    const double place = segments * middle / (times.back() - times.front());
    const auto knot = std::min(static_cast<std::size_t>(place), knots - 2);
    places_.push_back({knot, place - static_cast<double>(knot)});
  }
}

double LogLambdaCurve::update(std::span<const double> energies, std::span<const double> freedoms, double stiffness) {
  const std::vector<double> before = values_;
  const auto largest_change = [&](const std::vector<double>& from) {
    double largest = 0.0;
    for (std::size_t k = 0; k < from.size(); ++k) largest = std::max(largest, std::abs(values_[k] - from[k]));
    return largest;
  };
  for (int step = 0; step < most_newton_steps; ++step) {
    const std::vector<double> from = values_, move = newton_step(energies, freedoms, stiffness);
    const double cost_before = cost(energies, freedoms, stiffness);
    for (double share = 1.0; share > least_newton_share; share *= 0.5) {
      for (std::size_t k = 0; k < from.size(); ++k)
        values_[k] =
            std::clamp(from[k] + share * std::clamp(move[k], -longest_newton_step, longest_newton_step), least_, most_);
      if (cost(energies, freedoms, stiffness) <= cost_before) break;
    }
    if (largest_change(from) < newton_tolerance) break;
  }
  return largest_change(before);
}

double LogLambdaCurve::cost(std::span<const double> energies, std::span<const double> freedoms,
                            double stiffness) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double value = (*this)(i);
    sum += elementary::exponential(value) * energies[i] - freedoms[i] * value;
  }
  for (std::size_t k = 0; k + 1 < values_.size(); ++k) {
    const double difference = values_[k + 1] - values_[k];
    sum += 0.5 * stiffness * difference * difference;
  }
  return sum;
}

std::vector<double> LogLambdaCurve::newton_step(std::span<const double> energies, std::span<const double> freedoms,
                                                double stiffness) const {
  std::vector<double> diagonal(values_.size(), least_diagonal), beside(values_.size() - 1, -stiffness),
      right(values_.size(), 0.0);
  for (std::size_t k = 0; k + 1 < values_.size(); ++k) {
    const double pull = stiffness * (values_[k + 1] - values_[k]);
    diagonal[k] += stiffness;
    diagonal[k + 1] += stiffness;
    right[k] += pull;
    right[k + 1] -= pull;
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto& [knot, share] = places_[i];
    const double energy = elementary::exponential((*this)(i)) * energies[i], slope = freedoms[i] - energy;
    diagonal[knot] += energy * (1.0 - share) * (1.0 - share);
    diagonal[knot + 1] += energy * share * share;
    beside[knot] += energy * share * (1.0 - share);
    right[knot] += slope * (1.0 - share);
    right[knot + 1] += slope * share;
  }
  return solved(std::move(diagonal), beside, std::move(right));
}

void adapt_lambda(StretchProblems& problems, SmoothingObjective& objective, StretchFits& fits,
                  SmoothingCriterion criterion, double noise, double interval) {
  Adaptation adaptation(problems, objective, fits, criterion, noise, interval);
  double best = adaptation.value();
  const double cost_of_freedom = adaptation.freedom();
  double level = objective.lambda, before = best;
  bool taken = false;
  for (const auto& [stiffness, gain] : softnesses) {
    adaptation.soften(stiffness);
    Adaptation levelled = adaptation;
    levelled.choose_level(level, interval);
    if (objective.stopped()) return;
    level = levelled.lambda();
    const double value = levelled.value();
    if (value < best * (1.0 - gain * cost_of_freedom)) {
      best = value;
      problems = levelled.problems();
      objective.lambda = levelled.lambda();
      fits = levelled.fits();
      taken = true;
    }
    if (!(value < before * (1.0 - least_gain * cost_of_freedom))) break;
    before = value;
  }
  if (taken) fits = fit_stretches(problems, objective, {}, fits);
}

}}  // namespace orispline
