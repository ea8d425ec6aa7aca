// SPDX-License-Identifier: Apache-2.0
// What smoothing promises beside the golden cases: invariance, figures that follow from theory, outliers, gaps, a gyro.
#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/smooth/smoothing_choice.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_loss.hpp>
#include <orispline/smooth/smoothing_noise.hpp>
#include <orispline/smooth/smoothing_trace.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

using testing_support::relative_error;

SmoothingProblem problem_of(const KeyframeData& data, double noise) {
  return {.times = data.times,
          .orientations = data.orientations,
          .weights = std::vector<double>(data.times.size(), 1.0 / (noise * noise))};
}

class EveryPenalty : public testing::TestWithParam<Penalty> {};

TEST_P(EveryPenalty, IsInvariantUnderRotationsOfWorldAndBodyAndReversal) {
  const double noise = 2.0 * degree;
  const auto data = recorded(60, noise).noisy;
  const SmoothingObjective objective{.penalty = GetParam(), .lambda = lambda_of(0.03, GetParam(), noise, 0.01)};
  const auto fit = fit_smoothing(problem_of(data, noise), objective);
  const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(0.3, -2.0, 1.0)),
                           body = exp<double>(Eigen::Vector3d(1.0, 0.5, -0.7));
  KeyframeData turned = data, reversed = data;
  for (Eigen::Quaterniond& q : turned.orientations) q = world * q * body;
  std::ranges::reverse(reversed.orientations);
  for (std::size_t i = 0; i < data.times.size(); ++i) reversed.times[i] = -data.times[data.times.size() - 1 - i];
  const auto turned_fit = fit_smoothing(problem_of(turned, noise), objective);
  const auto reversed_fit = fit_smoothing(problem_of(reversed, noise), objective);
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    EXPECT_LT(angular_distance(turned_fit.nodes.orientations[i], world * fit.nodes.orientations[i] * body), 1e-9);
    EXPECT_LT(relative_error(turned_fit.nodes.angular_velocities[i], to_body(body, fit.nodes.angular_velocities[i])),
              1e-8);
    const std::size_t j = data.times.size() - 1 - i;
    EXPECT_LT(angular_distance(reversed_fit.nodes.orientations[j], fit.nodes.orientations[i]), 1e-9);
    EXPECT_LT(
        relative_error(Eigen::Vector3d(-reversed_fit.nodes.angular_velocities[j]), fit.nodes.angular_velocities[i]),
        1e-8);
  }
}

TEST_P(EveryPenalty, KeepsWhatThePenaltyDoesNotSee) {
  KeyframeData steady;
  for (int i = 0; i < 40; ++i) {
    steady.times.push_back(0.1 * i);
    steady.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.02 * i, 0.0)));
  }
  const auto fit = fit_smoothing(problem_of(steady, degree), {.penalty = GetParam(), .lambda = 1e4});
  for (std::size_t i = 0; i < steady.times.size(); ++i) {
    EXPECT_LT(angular_distance(fit.nodes.orientations[i], steady.orientations[i]), 1e-11);
    EXPECT_LT((fit.nodes.angular_velocities[i] - Eigen::Vector3d(0.0, 0.2, 0.0)).norm(), 1e-9);
  }
}

TEST_P(EveryPenalty, FindsTheSameMinimumFromAFitUnderAnotherLambda) {
  const double noise = 3.0 * degree;
  const auto data = recorded(300, noise).noisy;
  const auto objective = [noise](double smoothing_time) {
    return SmoothingObjective{.penalty = GetParam(), .lambda = lambda_of(smoothing_time, GetParam(), noise, 0.01)};
  };
  for (const double smoothing_time : {0.05, 0.2, 1.0}) {  // 5, 20 and 100 intervals
    const auto near = fit_smoothing(problem_of(data, noise), objective(smoothing_time / 1.3));
    const auto alone = fit_smoothing(problem_of(data, noise), objective(smoothing_time));
    const auto led = fit_smoothing(problem_of(data, noise), objective(smoothing_time), {}, &near.nodes);
    EXPECT_NEAR(led.cost, alone.cost, 1e-9 * alone.cost) << smoothing_time;
    EXPECT_LT(led.iterations, 20) << smoothing_time;
  }
}

TEST_P(EveryPenalty, EndsAtTheLowestCostThatItHasSeen) {
  // Orientations at random, between which the shorter way changes sides: steps may lead uphill, and not down again.
  for (const std::uint64_t seed : {1u, 11u, 34u, 49u, 73u, 231u, 246u}) {
    Dice dice(700 + seed);
    KeyframeData wild;
    for (std::size_t i = 0; i < 6 + seed % 4; ++i) {
      wild.times.push_back(static_cast<double>(i));
      wild.orientations.push_back(exp<double>(Eigen::Vector3d(3.0 * dice.vector())));
    }
    const SmoothingProblem problem = problem_of(wild, 0.1);
    for (const double smoothing_time : {0.5, 1.0, 2.0}) {
      const SmoothingObjective objective{.penalty = GetParam(),
                                         .lambda = lambda_of(smoothing_time, GetParam(), 0.1, 1.0)};
      double before = std::numeric_limits<double>::infinity();
      bool has_ended = false;
      for (int most = 1; !has_ended && most < 20; ++most) {
        const SmoothingFit fit = fit_smoothing(problem, objective, {.most = most});
        EXPECT_LE(fit.cost, before * (1.0 + 1e-11)) << "seed " << seed << ", step " << most;
        for (std::size_t i = 0; i < problem.size(); ++i)
          EXPECT_LT((fit.residuals[i] - shortest_increment(fit.nodes.orientations[i], wild.orientations[i])).norm(),
                    1e-12);
        before = std::min(before, fit.cost);
        has_ended = fit.iterations < most;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Smoothing, EveryPenalty, testing::Values(Penalty::acceleration, Penalty::jerk));

template <int P>
void expect_jacobian_of_element() {
  using Element = SmoothingElement<P>;
  Dice dice(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Eigen::Quaterniond from = exp<double>(dice.vector()), to = from * exp<double>(dice.vector());
    typename Element::Rates start, end;
    for (Eigen::Index k = 0; k < start.size(); k += 3) {
      start.template segment<3>(k) = 2.0 * dice.vector();
      end.template segment<3>(k) = 2.0 * dice.vector();
    }
    const double h = 0.7;
    const auto at = [&](const Eigen::Matrix<double, 2 * Element::unknowns, 1>& x) {
      constexpr int m = Element::unknowns;
      const Eigen::Quaterniond p = from * exp<double>(Eigen::Vector3d(x.template head<3>())),
                               q = to * exp<double>(Eigen::Vector3d(x.template segment<3>(m)));
      return Element::residual(shortest_increment(p, q), start + x.template segment<m - 3>(3),
                               end + x.template tail<m - 3>(), h);
    };
    const auto exact = Element::linearised(shortest_increment(from, to), start, end, h);
    Eigen::Matrix<double, 2 * Element::unknowns, 1> x = Eigen::Matrix<double, 2 * Element::unknowns, 1>::Zero();
    EXPECT_LT(relative_error(exact.residual, at(x)), 1e-12);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      constexpr double step = 1e-3;
      x.setZero();
      const auto difference = [&](double d) {
        x[k] = d;
        const typename Element::Residual forward = at(x);
        x[k] = -d;
        return typename Element::Residual(forward - at(x));
      };
      const typename Element::Residual slope = (8.0 * difference(step) - difference(2.0 * step)) / (12.0 * step);
      EXPECT_LT(relative_error(typename Element::Residual(exact.jacobian.col(k)), slope), 1e-9) << k;
    }
  }
}

TEST(SmoothingElement, JacobianIsThatOfTheResidual) {
  expect_jacobian_of_element<2>();
  expect_jacobian_of_element<3>();
}

TEST(SmoothingLoss, WeightsAreTheSlopesOfValuesWithoutAJump) {
  constexpr double threshold = 2.5, bound = threshold * threshold, step = 1e-5;
  for (const LossFunction loss : {LossFunction::l2, LossFunction::huber, LossFunction::tukey}) {
    SCOPED_TRACE(static_cast<int>(loss));
    for (const double s : {0.1, 1.0, 0.99 * bound, 1.01 * bound, 4.0 * bound}) {
      const double slope =
          (loss_at(loss, s + step, threshold).value - loss_at(loss, s - step, threshold).value) / (2.0 * step);
      EXPECT_NEAR(loss_at(loss, s, threshold).weight, slope, 1e-8) << s;
    }
    const LossValue within = loss_at(loss, bound * (1.0 - 1e-12), threshold),
                    beyond = loss_at(loss, bound * (1.0 + 1e-12), threshold);
    EXPECT_NEAR(within.value, beyond.value, 1e-10);
    EXPECT_NEAR(within.weight, beyond.weight, 1e-10);
  }
  EXPECT_EQ(loss_at(LossFunction::huber, 16.0, 2.0).value, 12.0);  // 2 c √s - c²
  EXPECT_EQ(loss_at(LossFunction::tukey, 100.0, 3.0).value, 3.0);  // c²/3
  EXPECT_EQ(loss_at(LossFunction::tukey, 100.0, 3.0).weight, 0.0);
}

TEST(SmoothingTrace, IsThatOfTheSplineFilter) {
  // Far from the ends the kernel of a cubic smoothing spline has the height 1/(2√2 τ) (Silverman 1984).
  std::vector<double> times, weights(4000, 1.0);
  for (int i = 0; i < 4000; ++i) times.push_back(i);
  const double trace =
      hat_trace({times, weights, Penalty::acceleration, lambda_of(10.0, Penalty::acceleration, 1.0, 1.0)});
  EXPECT_NEAR(trace / 4000.0, 1.0 / (20.0 * std::sqrt(2.0)), 0.001);
}

}}  // namespace orispline
