// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/math/eigen.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The order p of the penalty: that of the highest derivative of the orientation in it.
[[nodiscard]] constexpr int order_of(Penalty penalty) noexcept { return penalty == Penalty::acceleration ? 2 : 3; }

/// How the squared residual s, in units of the noise, counts. c is the threshold.
enum class LossFunction {
  l2,     ///< s
  huber,  ///< s up to c², 2c√s - c² beyond
  tukey,  ///< c²/3 (1 - (1 - s/c²)³) up to c², constant beyond
};

/// A noisy recording of an orientation, and of the body rate where there is a gyro; or one of a position.
struct SmoothingProblem {
  std::vector<double> times{};                     ///< [s], strictly increasing, at least two
  std::vector<Eigen::Quaterniond> orientations{};  ///< unit, of any sign, body to world
  std::vector<Eigen::Vector3d> positions{};        ///< in their place, and without a gyro; of any unit
  std::vector<double> weights{};                   ///< 1/σ² [1/rad²], σ per axis; 0 where there is no sample
  std::vector<double> shares{};                    ///< of the weights over that of a usual sample; empty: all 1
  std::vector<Eigen::Vector3d> gyro{};             ///< [rad/s], body frame; empty without a gyro
  std::vector<double> gyro_weights{};              ///< 1/σ² [s²/rad²] per axis; 0 where there is no rate
  std::array<bool, 3> dead_gyro_axes{};            ///< about which the gyro says nothing
  std::vector<double> relative_lambdas{};          ///< λ of each interval over that of the objective; empty: all 1

  [[nodiscard]] std::size_t size() const noexcept { return times.size(); }
  [[nodiscard]] double share(std::size_t sample) const noexcept { return shares.empty() ? 1.0 : shares[sample]; }
  [[nodiscard]] double relative_lambda(std::size_t interval) const noexcept {
    return relative_lambdas.empty() ? 1.0 : relative_lambdas[interval];
  }
};

/// What is to be made least.
struct SmoothingObjective {
  enum class Bias { none, constant, drifting };
  Penalty penalty = Penalty::acceleration;
  double lambda = 1.0;  ///< weight of the penalty [s³/rad²], of the jerk [s⁵/rad²]
  LossFunction loss = LossFunction::l2;
  double threshold = 2.5;         ///< of the loss, in units of σ
  Bias bias = Bias::none;         ///< of the gyro
  double drift = 0.0;             ///< of a bias that drifts, above 0: σ per axis of its change in 1 s [rad/s]
  double correlated_noise = 0.0;  ///< of orientations, without a gyro or with one whose bias drifts: σ per axis of a
                                  ///< first-order Markov part, beyond the white noise of the weights [rad]
  double correlation_time = 0.0;  ///< within which the correlation of that part falls to 1/e [s]
  bool finds_noise = false;       ///< for the restricted likelihood: all noises are known but for one common factor
  OpenEndedWork* work = nullptr;  ///< every step adds its times; the iteration ends early when it is stopped

  [[nodiscard]] bool stopped() const noexcept { return work && work->stopped(); }
};

/// How much shorter than the last step the next one is: by a constant factor, and by more the shorter the steps are,
/// for near the minimum they shrink by squares.
struct StepRatio {
  double ratio = std::numeric_limits<double>::infinity();
  double of = 0.0;  ///< after a step of this length [rad]

  [[nodiscard]] double next(double step) const { return ratio * step * std::max(1.0, step / of); }
};

/// When the iteration ends; also where the cost stays and steps do not get shorter: that is rounding.
struct SmoothingIteration {
  double tolerance = 1e-9;  ///< largest turn of a node in the last step [rad], or move of it
  int most = 60;            ///< steps
  bool foresees = false;    ///< ends too where the next step is sure to be within the tolerance, without making it
  StepRatio steps{};        ///< of a fit like this one, so that one step may be enough
};

/// The minimum and what is known about it.
struct SmoothingFit {
  SmoothedNodes nodes{};
  std::vector<Eigen::Vector3d> residuals{};  ///< log(q⁻¹ Q) to the recording [rad], body frame of the node; P - p
  std::vector<double> loss_weights{};        ///< ρ' of every residual: what is left of its weight
  double data = 0.0, penalty = 0.0, gyro = 0.0;  ///< terms of the cost, the penalty without the objective's λ
  double cost = 0.0;                             ///< data + λ penalty + gyro
  std::vector<double> interval_penalties{};      ///< of each interval, without any λ
  int iterations = 0;
  double last_step = 0.0;  ///< largest turn of a node in the last step [rad], or move of it; of the one foreseen
  StepRatio steps{};
};

/// Minimises Σ ρ(w |r|²) + λ ∫|ω^(p-1)|² dt + Σ w_g |ω - g - b|² over orientations, rates and bias at the times of the
/// recording, r = log(q⁻¹ Q). Linear in the number of times. A bias that drifts is one of each time, and adds
/// Σ |Δb|²/(drift² Δt). Correlated noise x of the orientations, in the body's frame, is one of each time too: r is then
/// log(q⁻¹ Q) - x, and |x₀|²/σ² + Σ |Δx|²/(σ² (1 - a²)) is added, Δx = x' - a x, a = exp(-Δt/correlation_time).
///
/// Gauss–Newton with the identity for the Hessian of |r|²/2, which majorises it, iterated weights for the loss, and
/// step halving; each step by block QR from node to node, which squares no condition number. The penalty is that of
/// the Hermite polynomial in the chart at the middle of each segment. Invariant under rotations of the world and of
/// the body and under reversal of time. docs/smooth.md has the formulas, our own derivation.
///
/// Positions p are linear: the cubic smoothing spline, for the jerk the quintic one, in one step; with a loss the
/// weights are iterated.
///
/// `start`: the fit of a similar problem at the same times. Precondition: as many weights as times, at least p of them
/// positive, and the same for the gyro where there is one.
[[nodiscard]] SmoothingFit fit_smoothing(const SmoothingProblem& problem, const SmoothingObjective& objective,
                                         const SmoothingIteration& iteration = {},
                                         const SmoothedNodes* start = nullptr);

/// fit_smoothing() of positions, in their unit: the smoothing spline of degree 2p-1 by block QR from node to node, with
/// iterated weights for the loss. Of `start` the positions are taken.
[[nodiscard]] SmoothingFit fit_positions(const SmoothingProblem& problem, const SmoothingObjective& objective,
                                         const SmoothingIteration& iteration, const SmoothedNodes* start);

/// Of a fit of orientations, by Laplace's method: from the inverse of the normal matrix at the fit, with the weights
/// that the loss leaves, where 1/σ² are the weights of samples and λ that of the motion. Linear time.
[[nodiscard]] NodeSigmas node_sigmas(const SmoothingProblem& problem, const SmoothingObjective& objective,
                                     const SmoothedNodes& nodes);

/// log det of the normal matrix at a fit, with the weights that the loss leaves.
[[nodiscard]] double log_determinant(const SmoothingProblem& problem, const SmoothingObjective& objective,
                                     const SmoothedNodes& nodes);

}}  // namespace orispline
