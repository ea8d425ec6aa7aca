// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/smooth/smoothing_choice.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// log λ of one stretch, piecewise linear over evenly spaced knots.
///
/// The values at the knots are those of the restricted likelihood with a penalty μ/2 Σ(difference of neighbours)² on
/// them: a random walk, so that few of them are free. What the likelihood asks of λ in an interval at a given fit is
/// λ E - d log λ, with E the squared penalty there in units of the noise and d how many values of it the samples
/// determine (MacKay's update); its minimum over all knots is found by Newton steps, each one tridiagonal system.
class LogLambdaCurve {
 public:
  /// One value for all of the intervals between these times [s]. `knots`: at least 2. No value rises above `most`;
  /// values that begin above it do not rise.
  LogLambdaCurve(std::span<const double> times, std::size_t knots, double log_lambda,
                 double most = std::numeric_limits<double>::infinity());

  /// The next values. `energies`: E; `freedoms`: d; both of every interval. The largest change of a value is returned.
  double update(std::span<const double> energies, std::span<const double> freedoms, double stiffness);

  /// Of an interval.
  [[nodiscard]] double operator()(std::size_t interval) const {
    const auto& [knot, share] = places_[interval];
    return values_[knot] + share * (values_[knot + 1] - values_[knot]);
  }

 private:
  struct Place {
    std::size_t knot;
    double share;  ///< of the next knot
  };

  [[nodiscard]] double cost(std::span<const double> energies, std::span<const double> freedoms, double stiffness) const;
  [[nodiscard]] std::vector<double> newton_step(std::span<const double> energies, std::span<const double> freedoms,
                                                double stiffness) const;

  std::vector<Place> places_;
  std::vector<double> values_;
  double least_, most_;
};

/// Lets λ vary within the stretches of a recording where that predicts the samples clearly better than one λ.
///
/// `problems`: whose relative λ are set, with the geometric mean 1 over all intervals, or left as they are where one λ
/// serves as well. `objective`: its λ is the one chosen for all, and becomes the mean one. `fits`: those with that λ,
/// and then the new ones. `criterion`: GCV or UBRE. `noise` and `interval`: as of lambda_of().
///
/// log λ is a LogLambdaCurve with about one knot for each degree of freedom of the curve with one λ, found by the
/// restricted likelihood; its mean is chosen anew by the criterion, which also decides whether it is taken: first a
/// stiff one, then softer ones, each only if the criterion falls clearly. Linear time.
void adapt_lambda(StretchProblems& problems, SmoothingObjective& objective, StretchFits& fits,
                  SmoothingCriterion criterion, double noise, double interval);

}}  // namespace orispline
