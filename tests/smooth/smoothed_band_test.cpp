// SPDX-License-Identifier: Apache-2.0
// The band of a smoothed motion: between nodes as that of a node without a sample, against quantiles of the chi
// distribution, and against the truth over seeded noise.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/smooth/smoothed_band.hpp>
#include <orispline/smooth/smoothing.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

constexpr double sixth = 1.0 / 6.0;

/// Samples of a gentle motion at uneven times, one in five of them rejected.
SmoothingProblem gentle(bool has_gyro) {
  SmoothingProblem problem;
  Dice dice(3);
  double t = 0.0;
  for (std::size_t i = 0; i < 40; ++i) {
    problem.times.push_back(t);
    problem.orientations.push_back(exp<double>(Eigen::Vector3d(0.3 * std::sin(t), 0.1 * t, 0.2 * std::cos(2.0 * t))) *
                                   exp<double>(Eigen::Vector3d(1e-3 * normal_vector(dice))));
    problem.weights.push_back(i % 5 == 2 ? 0.0 : 1e6);
    if (has_gyro) {
      problem.gyro.emplace_back(1e-2 * normal_vector(dice));
      problem.gyro_weights.push_back(1e4);
    }
    t += i % 3 == 0 ? 0.04 : 0.1;
  }
  return problem;
}

/// With a node more, of which nothing is known.
SmoothingProblem with_node(SmoothingProblem problem, std::size_t behind, double t) {
  const auto place = static_cast<std::ptrdiff_t>(behind + 1);
  problem.times.insert(problem.times.begin() + place, t);
  problem.orientations.insert(problem.orientations.begin() + place, problem.orientations[behind]);
  problem.weights.insert(problem.weights.begin() + place, 0.0);
  if (!problem.gyro.empty()) {
    problem.gyro.insert(problem.gyro.begin() + place, problem.gyro[behind]);
    problem.gyro_weights.insert(problem.gyro_weights.begin() + place, 0.0);
  }
  return problem;
}

NodeSigmas sigmas_at_minimum(const SmoothingProblem& problem, const SmoothingObjective& objective) {
  return node_sigmas(problem, objective, fit_smoothing(problem, objective).nodes);
}

double per_axis(const Eigen::Vector3d& sigma) { return std::sqrt(sigma.squaredNorm() / 3.0); }

TEST(SmoothedBand, IsBetweenNodesThatOfANodeWithoutASample) {
  using enum SmoothingObjective::Bias;
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk})
    for (const auto bias : {none, constant, drifting})
      for (const double correlated : {0.0, 1e-3}) {
        if (correlated > 0.0 && bias == constant) continue;  // which there is not
        const SmoothingProblem problem = gentle(bias != none);
        const SmoothingObjective objective{.penalty = penalty,
                                           .lambda = penalty == Penalty::jerk ? 0.1 : 1.0,
                                           .bias = bias,
                                           .drift = bias == drifting ? 1e-2 : 0.0,
                                           .correlated_noise = correlated,
                                           .correlation_time = 0.3};
        const NodeSigmas sigmas = sigmas_at_minimum(problem, objective);
        ASSERT_EQ(sigmas.to_next.size(), problem.size());
        for (const std::size_t i : {0u, 1u, 12u, 38u})
          for (std::size_t k = 0; k < NodeSigmas::within; ++k) {
            const double t =
                problem.times[i] + sixth * static_cast<double>(k + 1) * (problem.times[i + 1] - problem.times[i]);
            const NodeSigmas beside = sigmas_at_minimum(with_node(problem, i, t), objective);
            EXPECT_NEAR(sigmas.to_next[i][k] / per_axis(beside.orientations[i + 1]), 1.0, 0.005) << i << " " << k;
          }
      }
}

TEST(SmoothedBand, OfTheLastNodeIsItsOwn) {
  const NodeSigmas sigmas = sigmas_at_minimum(gentle(false), {});
  for (const double sigma : sigmas.to_next.back()) EXPECT_NEAR(sigma, per_axis(sigmas.orientations.back()), 1e-15);
}

/// Keys with such a band, one standard deviation of 0.01 everywhere.
Track even_keys(std::optional<double> gap = {}) {
  Track keys(Keyframes::make(
                 {.times = {0.0, 1.0, 2.0, 5.0, 6.0}, .orientations = std::vector(5, Eigen::Quaterniond::Identity())})
                 .value());
  keys.recipe.gap = gap;
  set_band(keys, {.orientations = std::vector(5, Eigen::Vector3d(0.01, 0.01, 0.01)),
                  .angular_velocities = {},
                  .to_next = std::vector(5, std::array{0.01, 0.01, 0.01, 0.01, 0.01})});
  return keys;
}

// Source: the quantiles of the chi distribution of three degrees of freedom, of SciPy 1.14.
TEST(SmoothedBand, HasTheRadiusOfItsShare) {
  for (const auto& [share, radius] :
       {std::pair(0.5, 1.5381722544550522), {0.9, 2.5002777108094975}, {0.99, 3.368214175218727}})
    for (const double t : {-1.0, 0.0, 0.7, 3.0, 6.0, 9.0})
      EXPECT_NEAR(SmoothedBand::make(even_keys(), share).value()(t), 0.01 * radius, 1e-14);
}

TEST(SmoothedBand, IsNothingInGapsAndAtNoTime) {
  const SmoothedBand band = SmoothedBand::make(even_keys(1.5), 0.9).value();
  for (const double t : {2.1, 4.9, std::nan("")}) EXPECT_TRUE(std::isnan(band(t)));
  for (const double t : {0.0, 2.0, 5.0, 5.5}) EXPECT_GT(band(t), 0.0);
}

TEST(SmoothedBand, RefusesSharesAndDeviationsThatAreNone) {
  for (const double share : {0.0, 1.0, -1.0, std::nan("")}) EXPECT_FALSE(SmoothedBand::make(even_keys(), share));
  for (const double sigma : {-0.01, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Track keys = even_keys();
    keys.settings["sigma_4of6"][3] = sigma;
    const auto band = SmoothedBand::make(keys, 0.9);
    ASSERT_FALSE(band);
    EXPECT_EQ(band.error().where.key, 3u);
    EXPECT_EQ(band.error().message.find("sigma_4of6: found "), 0u);
  }
}

TEST(SmoothedBand, IsForgottenByKeysOfAnotherCurve) {
  const Track keys = even_keys();
  EXPECT_TRUE(SmoothedBand::is_of(keys, smoothed_method));
  EXPECT_FALSE(SmoothedBand::is_of(keys, "auto"));
  EXPECT_FALSE(SmoothedBand::is_of(keys.at(std::vector<std::size_t>{0, 2, 4}), smoothed_method));
  EXPECT_FALSE(SmoothedBand::is_of(keys.with_times({0.0, 1.0, 3.0, 5.0, 6.0}).value(), smoothed_method));
  EXPECT_TRUE(SmoothedBand::is_of(keys.with_keys(keys.keys), smoothed_method));
}

/// Every second sample is seen; the truth is judged at the others, which lie between.
TEST(SmoothedBand, HoldsTheTruthBetweenSamples) {
  std::size_t inside = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Recording recording = wandering(1001, degree, seed);
    KeyframeData seen;
    for (std::size_t i = 0; i < recording.noisy.times.size(); i += 2) {
      seen.times.push_back(recording.noisy.times[i]);
      seen.orientations.push_back(recording.noisy.orientations[i]);
    }
    const Smoothing smoothing = smoothed(seen, {.sigma = true});
    const PoseCurve curve = make_pose_curve(smoothing.method, smoothing.track.keys).value();
    const SmoothedBand band = SmoothedBand::make(smoothing.track, 0.9).value();
    for (std::size_t i = 1; i < recording.clean.times.size(); i += 2, ++all) {
      const double t = recording.clean.times[i];
      const Eigen::Quaterniond q = curve.orientation(t);
      inside += angular_distance(q, recording.clean.orientations[i]) <= band(t) ? 1 : 0;
    }
  }
  const double share = static_cast<double>(inside) / static_cast<double>(all);
  EXPECT_GT(share, 0.85);
  EXPECT_LT(share, 0.95);
}

TEST(SmoothedBand, GoesWithTheKeysOfEveryStretch) {
  Recording recording = recorded(300, degree);
  for (std::size_t i = 150; i < 300; ++i) recording.noisy.times[i] += 10.0;
  const Smoothing smoothing = smoothed(recording.noisy, {.gap = 1.0, .sigma = true});
  const SmoothedBand band = SmoothedBand::make(smoothing.track, 0.9).value();
  EXPECT_TRUE(std::isnan(band(5.0)));
  EXPECT_NEAR(band(1.49), 2.5002777108094975 * per_axis(smoothing.sigmas->orientations[149]), 1e-12);
  EXPECT_FALSE(smoothed(recording.noisy, {.gap = 1.0}).track.settings.contains("sigma_0of6"));
}

}}  // namespace orispline
