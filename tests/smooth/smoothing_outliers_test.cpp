// SPDX-License-Identifier: Apache-2.0
// What is an outlier: leaving a sample out beside its definition, and what its neighbours say.
#include <gtest/gtest.h>

#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_outliers.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

using Indices = std::vector<std::size_t>;

TEST(PredictionErrors, AreThoseOfFitsWithoutTheSample) {
  const double noise = 0.5 * degree;
  const Keyframes keys = Keyframes::make(recorded(40, noise).noisy).value();
  const std::vector<Stretch> stretches{{0, 40}};
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk}) {
    const SmoothingObjective objective{.penalty = penalty, .lambda = lambda_of(0.02, penalty, noise, 0.01)};
    const auto problems = problems_of(keys, stretches, noise);
    const auto errors = prediction_errors(problems, fit_stretches(problems, objective), objective, noise)[0];
    for (const std::size_t sample : {0u, 7u, 20u, 39u}) {
      auto without = problems;
      without[0].weights[sample] = 0.0;
      const auto fits = fit_stretches(without, objective);
      EXPECT_NEAR(errors[sample], prediction_errors(without, fits, objective, noise)[0][sample], 0.01 * errors[sample]);
    }
  }
}

// Where little is smoothed the variance of a prediction counts the motion that may be: no error is taken for too large.
TEST(PredictionErrors, HaveTheSizeOfNormalOnesAtMost) {
  const double noise = degree;
  KeyframeData data = recorded(1500, 0.0).clean;
  Dice dice(3);
  for (Eigen::Quaterniond& q : data.orientations) q = q * exp<double>(Eigen::Vector3d(noise * normal_vector(dice)));
  const std::vector<Stretch> stretches{{0, 1500}};
  const auto problems = problems_of(Keyframes::make(data).value(), stretches, noise);
  for (const double smoothing_time : {0.005, 0.02, 0.05}) {
    const SmoothingObjective objective{.lambda = lambda_of(smoothing_time, Penalty::acceleration, noise, 0.01)};
    double sum = 0.0;
    const auto errors = prediction_errors(problems, fit_stretches(problems, objective), objective, noise);
    for (const double error : errors[0]) sum += error * error;
    EXPECT_LT(sum / 1500.0, 3.3) << smoothing_time;
    EXPECT_GT(sum / 1500.0, smoothing_time > 0.01 ? 2.7 : 1.5) << smoothing_time;
  }
}

TEST(FarCandidates, AreThoseThatStandOutOfARunToo) {
  const std::vector<Stretch> stretches{{0, 9}};
  const auto far = far_candidates({{1, 6, 7, 90, 8, 1, 9, 9, 1}}, stretches);
  EXPECT_EQ(far.single, (Indices{3, 6, 7}));
  EXPECT_EQ(far.in_runs, (Indices{1, 2, 4}));
  EXPECT_EQ(far_candidates({{1, 90, 91, 92, 1, 1, 1, 1, 1}}, stretches).in_runs, (Indices{1, 2, 3}));
}

TEST(SmoothingVerdict, AsksTheNeighboursThatCount) {
  const std::vector<Stretch> stretches{{10, 8}};
  const auto verdict = [&](std::vector<double> errors, const Indices& left_out) {
    return judged({.single = left_out, .in_runs = {}}, {std::move(errors)}, stretches);
  };
  EXPECT_EQ(verdict({1, 1, 1, 9, 1, 1, 1, 1}, {13}).single, Indices{13});
  EXPECT_EQ(verdict({1, 1, 1, 9, 4, 1, 1, 1}, {13}).in_runs, Indices{13});  // the neighbour is far too
  EXPECT_EQ(verdict({1, 1, 1, 9, 1, 4, 1, 1}, {13}).in_runs, Indices{13});  // so is the next but one
  EXPECT_EQ(verdict({4, 1, 1, 9, 1, 1, 4, 1}, {13}).single, Indices{13});   // these are too far off to say anything
  EXPECT_EQ(verdict({1, 1, 1, 40, 4, 1, 1, 1}, {13}).single, Indices{13});  // many times nearer
  EXPECT_EQ(verdict({1, 1, 1, 9, 9, 1, 1, 1}, {13, 14}).single, (Indices{13, 14}));   // one beside it does not count
  EXPECT_EQ(verdict({1, 1, 1, 4.9, 1, 1, 1, 1}, {13}).in_runs, Indices{13});          // near to what the others predict
  EXPECT_EQ(verdict({9, 1, 1, 1, 1, 1, 1, 9}, {10, 17}).in_runs, (Indices{10, 17}));  // of one side only
}

TEST(OutstandingSamples, AreThoseOfWhichTheMotionDoesNotTheLike) {
  const std::vector<Stretch> stretches{{10, 8}, {20, 8}};
  const auto verdict = [&](Indices single, Indices in_runs, const Indices& motion = {}) {
    const std::vector<double> before{1, 30, 1, 1, 7, 8, 7, 1}, after{1, 1, 6, 1, 1, 1, 9, 1};
    return outstanding({.single = std::move(single), .in_runs = std::move(in_runs)}, motion, {before, after},
                       stretches);
  };
  EXPECT_EQ(verdict({11, 22}, {}).single, (Indices{11, 22}));
  EXPECT_EQ(verdict({11, 22}, {14, 15, 16}).single, (Indices{11, 22}));  // one place, and two single samples
  EXPECT_EQ(verdict({22}, {14, 15, 16}).in_runs, (Indices{14, 15, 16, 22}));
  EXPECT_EQ(verdict({11}, {14, 15, 16, 26}).single, Indices{11});  // more than three times as far as any of them
  EXPECT_EQ(verdict({11, 22}, {14, 15, 16, 26}).in_runs, (Indices{14, 15, 16, 22, 26}));
  EXPECT_EQ(verdict({22}, {}, {14, 15, 16}).in_runs, Indices{22});  // motion beside another fit
  EXPECT_EQ(verdict({22}, {}, {22}).single, Indices{22});
  EXPECT_EQ(verdict({22}, {}, {10, 12, 13, 17}).single, Indices{22});  // which is followed now
}

}}  // namespace orispline
