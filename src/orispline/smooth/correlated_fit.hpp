// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <orispline/smooth/smoothing_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The smooth motion of orientations whose noise correlates, without a gyro.
struct CorrelatedFit {
  StretchProblems problems{};
  SmoothingObjective objective{};  ///< with λ
  StretchFits fits{};
  ChosenLambda chosen{};  ///< without its fits
  double noise = 0.0;     ///< σ per axis [rad], as stated or found
};

/// What is known of the noise.
struct CorrelatedNoisePlan {
  double time = 0.0;              ///< within which its correlation falls to 1/e [s]
  std::optional<double> noise{};  ///< σ per axis [rad]; absent: found
  double interval = 0.0;          ///< median one [s]
};

/// The noise is a first-order Markov process, and λ, and σ where nobody states it, are those of the greatest restricted
/// likelihood. Outliers are those of the search, which took the noise for white; its λ does not matter. Linear time.
/// Errors: not_converged; cancelled.
[[nodiscard]] Expected<CorrelatedFit> fit_with_correlated_noise(const SmoothingSearch& white,
                                                                const CorrelatedNoisePlan& plan);

/// The longest time of correlation that a recording with samples at these times can tell of [s]: a quarter of it.
[[nodiscard]] double longest_noise_time(std::span<const double> times);
/// Error (bad_argument): `noise_time` is longer than that.
[[nodiscard]] Expected<void> check_noise_time(double noise_time, std::span<const double> times);

/// How large noise that correlates within `time` [s] could be at most, per axis [rad], by the distances of orientations
/// from the middle between those before and behind them: of neighbours and of some that are farther apart. All of that
/// could be noise.
[[nodiscard]] double most_correlated_noise(std::span<const double> times,
                                           std::span<const Eigen::Quaterniond> orientations, double time);

}}  // namespace orispline
