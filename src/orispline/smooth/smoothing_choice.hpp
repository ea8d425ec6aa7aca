// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// λ of a smoothing time τ [s]: the smoother's gain at the frequency f is 1/(1 + (2π f τ)^2p), one half at 1/(2π τ).
/// `noise`: σ per axis, in the unit of the samples; `interval`: between samples [s].
[[nodiscard]] double lambda_of(double smoothing_time, Penalty penalty, double noise, double interval);
[[nodiscard]] double smoothing_time_of(double lambda, Penalty penalty, double noise, double interval);

/// The stretches of a recording, which share λ and no motion.
using StretchProblems = std::vector<SmoothingProblem>;

/// Fits of all stretches.
struct StretchFits {
  std::vector<SmoothingFit> fits{};

  [[nodiscard]] double data() const noexcept;
};

/// Fits every stretch. `start`: fits of the same stretches, or none.
[[nodiscard]] StretchFits fit_stretches(const StretchProblems& stretches, const SmoothingObjective& objective,
                                        const SmoothingIteration& iteration = {}, const StretchFits& start = {});

/// Standard deviations at the nodes of all stretches, where the noises are those of the weights and the objective.
[[nodiscard]] NodeSigmas sigmas_of(const StretchProblems& stretches, const SmoothingObjective& objective,
                                   const StretchFits& fits);

/// Whether the last steps moved no node by more than the noise.
[[nodiscard]] bool converged(const StretchFits& fits, double noise);

/// Times with an orientation that counts.
[[nodiscard]] std::size_t observations(const StretchProblems& stretches);

/// The trace of the hat matrix per axis, over all stretches, with the weights that the loss leaves.
[[nodiscard]] double hat_trace(const StretchProblems& stretches, const StretchFits& fits, Penalty penalty,
                               double lambda);

/// The weights of the samples that the loss leaves at a fit.
[[nodiscard]] std::vector<double> weights_left(const SmoothingProblem& problem, const SmoothingFit& fit);

/// What is to be least; by REML one λ for all intervals is meant.
[[nodiscard]] double criterion_value(const StretchProblems& stretches, const StretchFits& fits,
                                     SmoothingCriterion criterion, const SmoothingObjective& objective);

/// The longest τ that is to be trusted [s]: beyond it rounding spoils the fit, and no motion is left to find.
[[nodiscard]] double longest_smoothing_time(const StretchProblems& stretches, double interval);

/// λ, the fits from which it was chosen that are nearest to it, and the times that they saw.
struct ChosenLambda {
  LambdaChoice choice{};
  StretchFits fits{};  ///< of all stretches; none where parts of them were enough
  std::size_t times = 0;
};

/// Scans τ upward from half the interval until the criterion has risen for two steps of 1.3², looks about the least
/// value in steps of 1.3 and refines it by a parabola in log τ. `noise`, `interval`: as of lambda_of(). The objective's
/// λ is not used. `start`: fits of the same stretches, or none. Where `near` is given the scan goes from that τ
/// downhill. Where the stretches have more than `most_times_for_choice` times, their representative parts are enough;
/// to scan upward a quarter of that is.
[[nodiscard]] ChosenLambda chosen_lambda(const StretchProblems& stretches, const StretchFits& start,
                                         const SmoothingObjective& objective, SmoothingCriterion criterion,
                                         double noise, double interval, std::optional<double> near = std::nullopt);

/// Parts of the stretches, evenly spread, with `most` times altogether, or a little more; the stretches themselves
/// where they have no more: for a choice of λ that need not see everything.
[[nodiscard]] StretchProblems representative_parts(const StretchProblems& stretches, std::size_t most);

/// About how many steps of the iteration, each times its samples, the choice on so many of them and the fits take.
[[nodiscard]] double expected_work(std::size_t samples, std::size_t most_of_choice) noexcept;

}}  // namespace orispline
