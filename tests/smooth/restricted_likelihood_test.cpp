// SPDX-License-Identifier: Apache-2.0
// The restricted likelihood of several stretches beside its definition (Patterson & Thompson 1971, Harville 1974): of
// values y = X β + noise of the covariance V, -2 log is log|V| + log|Xᵀ V⁻¹ X| + yᵀ P y but for a constant. A motion
// whose penalty is integrated has polynomials for X, and in V the covariance of white noise that is integrated as
// often.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <orispline/smooth/smoothing_choice.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

/// Turns of so little [rad] that they add up like vectors: their products are smaller by this factor.
constexpr double tiny = 1e-8;
/// Of differences of the likelihood: what the products of turns and the iteration leave of some hundred squares.
constexpr double agreement = 1e-6;

/// ∫ (s-u)^a/a! (t-u)^b/b! du up to the earlier time: of white noise that is integrated a+1 and b+1 times.
double covariance(double s, int a, double t, int b) {
  constexpr std::array nodes{-0.7745966692414834, 0.0, 0.7745966692414834}, weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const double half = 0.5 * std::min(s, t);  // Gauss's rule of three points, exact up to degree 5
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double u = half * (1.0 + nodes[k]);
    sum += half * weights[k] * std::pow(s - u, a) / std::tgamma(a + 1) * std::pow(t - u, b) / std::tgamma(b + 1);
  }
  return sum;
}

/// A turn or a rate that was seen of a stretch.
struct Seen {
  double time;
  int derivative;  // 0: a turn, 1: a rate
  double variance;
  Eigen::Vector3d value;
};

std::vector<Seen> seen_of(const SmoothingProblem& stretch) {
  std::vector<Seen> all;
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    const double t = stretch.times[i] - stretch.times[0];
    if (stretch.weights[i] > 0.0) all.push_back({t, 0, 1.0 / stretch.weights[i], log<double>(stretch.orientations[i])});
    if (!stretch.gyro.empty() && stretch.gyro_weights[i] > 0.0)
      all.push_back({t, 1, 1.0 / stretch.gyro_weights[i], stretch.gyro[i]});
  }
  return all;
}

double by_definition(const std::vector<SmoothingProblem>& stretches, const SmoothingObjective& objective) {
  using Bias = SmoothingObjective::Bias;
  const int order = objective.penalty == Penalty::acceleration ? 2 : 3;
  double logarithms = 0.0, squares = 0.0, freedom = 0.0;
  for (const SmoothingProblem& stretch : stretches) {
    const std::vector<Seen> seen = seen_of(stretch);
    const auto rows = static_cast<Eigen::Index>(seen.size()),
               columns = static_cast<Eigen::Index>(order + (objective.bias == Bias::none ? 0 : 1));
    Eigen::MatrixXd v(rows, rows), x = Eigen::MatrixXd::Zero(rows, columns), y(rows, 3);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Seen& a = seen[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < rows; ++j) {
        const Seen& b = seen[static_cast<std::size_t>(j)];
        v(i, j) = covariance(a.time, order - 1 - a.derivative, b.time, order - 1 - b.derivative) / objective.lambda +
                  (i == j ? a.variance : 0.0);
        if (a.derivative + b.derivative == 0 && objective.correlated_noise > 0.0)
          v(i, j) += std::pow(objective.correlated_noise, 2) *
                     std::exp(-std::abs(a.time - b.time) / objective.correlation_time);
        if (a.derivative + b.derivative == 2 && objective.bias == Bias::drifting)
          v(i, j) += std::pow(objective.drift, 2) * std::min(a.time, b.time);
      }
      for (int k = a.derivative; k < order; ++k)
        x(i, k) = std::pow(a.time, k - a.derivative) / std::tgamma(k - a.derivative + 1);
      if (a.derivative == 1 && objective.bias != Bias::none) x(i, order) = 1.0;
      y.row(i) = a.value;
    }
    const Eigen::LLT<Eigen::MatrixXd> root(v);
    const Eigen::MatrixXd white_x = root.matrixL().solve(x), white_y = root.matrixL().solve(y);
    const Eigen::HouseholderQR<Eigen::MatrixXd> factor(white_x);
    logarithms += 2.0 * (root.matrixLLT().diagonal().array().log().sum() +
                         factor.matrixQR().diagonal().array().abs().log().sum());
    squares += (factor.householderQ().adjoint() * white_y).bottomRows(rows - columns).squaredNorm();
    freedom += 3.0 * static_cast<double>(rows - columns);
  }
  return 3.0 * logarithms + (objective.finds_noise ? freedom * std::log(squares) : squares);
}

/// Three stretches of different lengths, with uneven times, and times without an orientation or without a rate.
std::vector<SmoothingProblem> any_stretches(bool has_gyro) {
  Dice dice(41);
  std::vector<SmoothingProblem> all;
  for (const std::size_t count : {9u, 16u, 6u}) {
    SmoothingProblem& stretch = all.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      stretch.times.push_back(10.0 * static_cast<double>(all.size()) + 0.1 * static_cast<double>(i) +
                              dice.between(0.0, 0.05));
      const double t = stretch.times.back() - stretch.times.front();
      stretch.orientations.push_back(exp<double>(
          Eigen::Vector3d(tiny * (Eigen::Vector3d(3.0 * std::sin(4.0 * t), 2.0 * t, t * t) + 2.0 * dice.vector()))));
      stretch.weights.push_back(i == 4 ? 0.0 : dice.between(0.5, 2.0) / (tiny * tiny));
      if (!has_gyro) continue;
      stretch.gyro.emplace_back(tiny * (Eigen::Vector3d(12.0 * std::cos(4.0 * t), 2.0, 2.0 * t) + 5.0 * dice.vector()));
      stretch.gyro_weights.push_back(i == 2 ? 0.0 : dice.between(0.02, 0.1) / (tiny * tiny));
    }
  }
  return all;
}

class RestrictedLikelihood : public testing::TestWithParam<Penalty> {
 protected:
  [[nodiscard]] double likelihood(const std::vector<SmoothingProblem>& stretches,
                                  const SmoothingObjective& objective) const {
    const StretchFits fits = fit_stretches(stretches, objective, {.tolerance = 1e-9 * tiny});
    return criterion_value(stretches, fits, SmoothingCriterion::reml, objective);
  }
  /// From the first objective to each other one.
  void expect_differences(const std::vector<SmoothingObjective>& objectives, bool has_gyro) const {
    const auto stretches = any_stretches(has_gyro);
    const double first = likelihood(stretches, objectives[0]), wanted_first = by_definition(stretches, objectives[0]);
    for (std::size_t k = 1; k < objectives.size(); ++k) {
      const double wanted = by_definition(stretches, objectives[k]) - wanted_first;
      EXPECT_GT(std::abs(wanted), 0.1) << k;
      EXPECT_NEAR(likelihood(stretches, objectives[k]) - first, wanted, agreement) << k;
    }
  }
  /// With smoothing times of a half to five intervals.
  [[nodiscard]] std::vector<SmoothingObjective> scan(SmoothingObjective objective) const {
    std::vector<SmoothingObjective> all;
    objective.penalty = GetParam();
    for (const double time : {0.05, 0.1, 0.2, 0.5}) {
      objective.lambda = lambda_of(time, GetParam(), tiny, 0.1);
      all.push_back(objective);
    }
    return all;
  }
};

TEST_P(RestrictedLikelihood, OfOrientationsIsThatOfItsDefinition) { expect_differences(scan({}), false); }

TEST_P(RestrictedLikelihood, WithNoiseThatIsFoundIsThatOfItsDefinition) {
  expect_differences(scan({.finds_noise = true}), false);
  expect_differences(scan({.correlated_noise = 2.0 * tiny, .correlation_time = 0.3, .finds_noise = true}), false);
}

TEST_P(RestrictedLikelihood, WithAGyroIsThatOfItsDefinition) {
  using Bias = SmoothingObjective::Bias;
  expect_differences(scan({.bias = Bias::none}), true);
  expect_differences(scan({.bias = Bias::constant}), true);
  auto drifting = scan({.bias = Bias::drifting, .drift = 5.0 * tiny});
  for (const double drift : {1.0 * tiny, 20.0 * tiny}) {
    drifting.push_back(drifting[1]);
    drifting.back().drift = drift;
  }
  expect_differences(drifting, true);
}

INSTANTIATE_TEST_SUITE_P(Smoothing, RestrictedLikelihood, testing::Values(Penalty::acceleration, Penalty::jerk));

}}  // namespace orispline
