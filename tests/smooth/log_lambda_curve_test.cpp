// SPDX-License-Identifier: Apache-2.0
// The curve of log λ, and how much of the penalised rate the samples determine in each interval.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <orispline/smooth/smoothing_trace.hpp>
#include <orispline/smooth/varying_lambda.hpp>

namespace orispline { namespace {

std::vector<double> wavering_times(std::size_t count) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<double>(i);
    times.push_back(n + 0.3 * std::sin(7.0 * n));
  }
  return times;
}

TEST(IntervalFreedoms, AreThoseOfTheCurveButForWhatNoPenaltySees) {
  const std::vector<double> times = wavering_times(60);
  std::vector<double> weights, shares;
  for (std::size_t i = 0; i < 60; ++i) weights.push_back(i % 7 == 3 ? 0.0 : 1.0 + 0.01 * static_cast<double>(i));
  for (std::size_t i = 0; i < 59; ++i) shares.push_back(i < 30 ? 0.1 : 30.0);
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk}) {
    const ScalarSmoother smoother{times, weights, penalty, 5.0, shares};
    const auto freedoms = interval_freedoms(smoother);
    ASSERT_EQ(freedoms.size(), 59u);
    EXPECT_NEAR(std::accumulate(freedoms.begin(), freedoms.end(), 0.0), hat_trace(smoother) - order_of(penalty), 1e-9);
    for (const double freedom : freedoms) {
      EXPECT_GT(freedom, -1e-9);
      EXPECT_LT(freedom, order_of(penalty));
    }
  }
}

TEST(LogLambdaCurve, IsThatOfTheLikelihoodWhereOneValueServes) {
  const std::vector<double> times = wavering_times(50), energies(49, 0.25), freedoms(49, 2.0);
  LogLambdaCurve curve(times, 7, 0.0);
  curve.update(energies, freedoms, 3.0);
  for (std::size_t i = 0; i < 49; ++i) EXPECT_NEAR(curve(i), std::log(2.0 / 0.25), 1e-6) << i;
}

TEST(LogLambdaCurve, FollowsAChangeAsFarAsItIsSoft) {
  const std::vector<double> times = wavering_times(200), freedoms(199, 1.0);
  std::vector<double> energies(199, 1.0);
  for (std::size_t i = 100; i < 199; ++i) energies[i] = std::exp(-6.0);
  LogLambdaCurve soft(times, 21, 1.0), stiff(times, 21, 1.0);
  soft.update(energies, freedoms, 0.01);
  stiff.update(energies, freedoms, 1e6);
  EXPECT_NEAR(soft(10), 0.0, 0.05);
  EXPECT_NEAR(soft(190), 6.0, 0.05);
  EXPECT_NEAR(stiff(10), stiff(190), 1e-3);
}

TEST(LogLambdaCurve, StaysWithinBoundsWhereNothingIsSaid) {
  const std::vector<double> times = wavering_times(50), energies(49, 0.0), freedoms(49, 1.0);
  LogLambdaCurve curve(times, 5, 2.0);
  for (int k = 0; k < 20; ++k) curve.update(energies, freedoms, 1.0);
  EXPECT_DOUBLE_EQ(curve(0), 20.0);
}

TEST(LogLambdaCurve, RisesNoHigherThanItMay) {
  const std::vector<double> times = wavering_times(50), energies(49, 0.0), freedoms(49, 1.0);
  for (const double most : {1.0, 5.0}) {
    LogLambdaCurve curve(times, 5, 2.0, most);
    for (int k = 0; k < 20; ++k) curve.update(energies, freedoms, 1.0);
    EXPECT_DOUBLE_EQ(curve(0), std::max(most, 2.0));
  }
}

}}  // namespace orispline
