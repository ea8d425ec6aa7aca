// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/log_lambda_curve.hpp>

#include <algorithm>
#include <cmath>

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
    sum += std::exp(value) * energies[i] - freedoms[i] * value;
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
    const double energy = std::exp((*this)(i)) * energies[i], slope = freedoms[i] - energy;
    diagonal[knot] += energy * (1.0 - share) * (1.0 - share);
    diagonal[knot + 1] += energy * share * share;
    beside[knot] += energy * share * (1.0 - share);
    right[knot] += slope * (1.0 - share);
    right[knot + 1] += slope * share;
  }
  return solved(std::move(diagonal), beside, std::move(right));
}

}}  // namespace orispline
