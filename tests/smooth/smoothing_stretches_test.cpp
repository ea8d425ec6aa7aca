// SPDX-License-Identifier: Apache-2.0
// What smoothing does with samples that are far away, with recordings at the edges of what it can tell, and with very
// long ones.
#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_stretches.hpp>
#include <smooth/noisy_motion.hpp>

namespace orispline { namespace {

using Indices = std::vector<std::size_t>;

/// Turns about z by sin(2t) at 100 Hz, with turns about random axes of at most `noise` per axis [rad].
KeyframeData turning(std::size_t count, double noise) {
  Dice dice(5);
  KeyframeData data;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, std::sin(2.0 * t))) *
                                exp<double>(Eigen::Vector3d(noise * dice.vector())));
  }
  return data;
}

void turn(KeyframeData& data, std::size_t i, double angle) {
  data.orientations[i] = data.orientations[i] * exp<double>(Eigen::Vector3d(angle, 0.0, 0.0));
}

TEST(SmoothingOutliers, AreThoseBeyondFiveTimesTheNoise) {
  auto data = turning(600, 0.05 * degree);
  turn(data, 150, 4.6 * degree);
  turn(data, 300, 5.6 * degree);
  EXPECT_EQ(smoothed(data, {.noise = degree}).rejected, Indices{300});
  // Where more noise is found than was stated, that one counts.
  EXPECT_LE(smoothed(turning(600, degree), {.noise = 0.1 * degree}).rejected.size(), 2u);
}

TEST(SmoothingOutliers, ThreeInARowAreMotion) {
  auto data = turning(600, 0.3 * degree);
  for (const std::size_t i : {100u, 200u, 201u, 300u, 301u, 302u}) turn(data, i, 30.0 * degree);
  const auto smoothing = smoothed(data);
  EXPECT_EQ(smoothing.rejected, (Indices{100, 200, 201}));
  EXPECT_TRUE(std::ranges::includes(smoothing.retained_outlier_runs, Indices{300, 301, 302}));
  for (const std::size_t i : smoothing.retained_outlier_runs) EXPECT_NEAR(static_cast<double>(i), 301.0, 5.0);
}

TEST(SmoothingOutliers, OfTukeyHaveNoWeight) {
  auto data = turning(600, 0.3 * degree);
  for (const std::size_t i : {100u, 200u}) turn(data, i, 30.0 * degree);
  EXPECT_EQ(smoothed(data, {.smoothing_time = 0.03, .loss = Loss::tukey}).rejected, (Indices{100, 200}));
  EXPECT_EQ(smoothed(data, {.loss = Loss::huber}).rejected, Indices{});
}

TEST(SmoothingOutliers, RunsEndWithTheirStretch) {
  const std::vector<Stretch> stretches{{0, 5}, {7, 4}};
  const auto far = far_samples({{0, 2, 0, 2, 2}, {2, 0, 2, 0}}, stretches, 1.0);
  EXPECT_EQ(far.single, (Indices{1, 3, 4, 7, 9}));
  EXPECT_TRUE(far.in_runs.empty());
  EXPECT_EQ(far_samples({{2, 2, 2, 0, 0}, {0, 2, 2, 2}}, stretches, 1.0).in_runs, (Indices{0, 1, 2, 8, 9, 10}));
}

TEST(SmoothingOutliers, LeaveEnoughOfEveryStretch) {
  const auto recording = Keyframes::make(turning(12, 0.0)).value();
  const std::vector<Stretch> stretches{{0, 5}, {7, 4}};
  auto problems = problems_of(recording, stretches, 0.1);
  const auto far = reject(problems, stretches, {.single = {1, 7, 10}}, Penalty::acceleration).value();
  EXPECT_EQ(far.single, Indices{1});
  EXPECT_EQ(far.in_runs, (Indices{7, 10}));  // two others are too few
  EXPECT_EQ(problems[0].weights[1], 0.0);
  EXPECT_GT(problems[1].weights[0], 0.0);
  const std::vector<Stretch> one{{0, 4}};
  problems = problems_of(recording, one, 0.1);
  const auto refused = reject(problems, one, {.single = {0, 3}}, Penalty::acceleration);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_data);
  EXPECT_EQ(refused.error().message, "of 4 samples 2 are outliers, wanted at least 3 others");
}

TEST(SmoothingEdges, WithoutNoiseTheSamplesStay) {
  const auto data = turning(300, 0.0);
  const auto smoothing = smoothed(data);
  EXPECT_EQ(smoothing.edge, LambdaChoice::Edge::shortest);
  EXPECT_TRUE(smoothing.rejected.empty());
  for (std::size_t i = 0; i < data.times.size(); ++i)
    EXPECT_LT(angular_distance(smoothing.nodes.orientations[i], data.orientations[i]), 1e-4) << i;
}

TEST(SmoothingEdges, WithoutMotionNoiseIsAllThereIs) {
  auto data = turning(300, degree);
  for (std::size_t i = 0; i < data.times.size(); ++i)
    data.orientations[i] =
        exp<double>(Eigen::Vector3d(0.0, 0.0, -std::sin(2.0 * data.times[i]))) * data.orientations[i];
  const auto smoothing = smoothed(data, {.noise = 2.0 * degree});
  EXPECT_EQ(smoothing.edge, LambdaChoice::Edge::longest);
  for (const Eigen::Quaterniond& q : smoothing.nodes.orientations)
    EXPECT_LT(angular_distance(q, Eigen::Quaterniond::Identity()), 0.3 * degree);
}

TEST(RepresentativeParts, AreSpreadEvenlyAndNoMoreThanAskedFor) {
  const auto recording = Keyframes::make(turning(30000, 0.0)).value();
  const std::vector<Stretch> stretches{{0, 20000}, {20000, 10000}};
  const auto problems = problems_of(recording, stretches, 0.1);
  EXPECT_EQ(representative_parts(problems, 30000).size(), 2u);
  const auto parts = representative_parts(problems, 15000);
  std::size_t all = 0, in_first = 0;
  for (const SmoothingProblem& part : parts) {
    all += part.size();
    if (part.times.back() < 200.0) in_first += part.size();
    EXPECT_EQ(part.orientations.size(), part.size());
    EXPECT_EQ(part.weights.size(), part.size());
    EXPECT_GE(part.size(), 2500u);
  }
  EXPECT_EQ(all, 15000u);
  EXPECT_EQ(in_first, 10000u);
  EXPECT_EQ(parts.front().times.front(), 0.0);
  EXPECT_EQ(parts.back().times.back(), recording.times().back());
}

}}  // namespace orispline
