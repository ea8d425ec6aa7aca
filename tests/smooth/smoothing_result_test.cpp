// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_result.hpp>

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/smooth/smooth.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

/// Two stretches of ten samples in 20, one apart from the other by a second.
Smoothing two_stretches() {
  auto recording = recorded(20, degree);
  for (std::size_t i = 10; i < 20; ++i) recording.noisy.times[i] += 1.0;
  return smooth(Keyframes::make(recording.noisy).value(), {.smoothing_time = 0.05, .gap = 0.5}).value();
}

TEST(SmoothingResult, CoversItsStretchesWithBothEndsAndNotTheGap) {
  const Smoothing smoothing = two_stretches();
  for (const double t : {0.0, 0.035, 0.09, 1.1, 1.19}) EXPECT_TRUE(smoothing.covers(t)) << t;
  for (const double t : {-0.01, 0.095, 0.5, 1.09, 1.2}) EXPECT_FALSE(smoothing.covers(t)) << t;
}

TEST(SmoothingResult, CutsOffAtTheReciprocalOfItsTime) {
  EXPECT_DOUBLE_EQ(Smoothing{.smoothing_time = 0.5}.cutoff(), 1.0 / std::numbers::pi);
}

TEST(SmoothingResult, WarnsOfTheLongestRunOfRejectedSamplesWithItsPlace) {
  Smoothing smoothing{.keys = std::vector<std::size_t>(900),
                      .stretches = {{0, 20}, {20, 20}},
                      .rejected = {1, 2, 5, 6, 7, 18, 19, 20, 21}};
  const auto warnings = warnings_of(smoothing);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "rejected_run");
  EXPECT_EQ(warnings[0].where.key, 5u);  // 18 to 21 lie in two stretches
  EXPECT_EQ(warnings[0].number("samples"), 3u);
  smoothing.rejected = {1, 2, 5, 6};
  EXPECT_TRUE(warnings_of(smoothing).empty());
}

TEST(SmoothingResult, WarnsOfMoreThanOneRejectedSampleInAHundred) {
  Smoothing smoothing{.keys = std::vector<std::size_t>(200), .stretches = {{0, 200}}, .rejected = {1, 50, 100}};
  const auto warnings = warnings_of(smoothing);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "many_rejected");
  EXPECT_EQ(warnings[0].number("samples"), 3.0);
  EXPECT_TRUE(warnings[0].message.starts_with("3 of 200 samples (1.5 %) are rejected as outliers"));
  smoothing.rejected = {1, 50};
  EXPECT_TRUE(warnings_of(smoothing).empty());
}

TEST(SmoothingResult, WarnsOfARecordingThatIsShortForItsNoise) {
  Smoothing smoothing{.track = Track(Keyframes::make(recorded(201, degree).noisy).value()),  // of 2 s
                      .correlated_noise = Smoothing::CorrelatedNoise{.sigma = degree, .time = 0.11},
                      .gyro = GyroFinding{.risk = GyroFinding::Risk{.with = 0.01, .without = 0.04}, .used = true}};
  const auto warnings = warnings_of(smoothing);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "short_for_its_noise");
  EXPECT_EQ(warnings[0].number("least_rad"), 0.005);
  EXPECT_EQ(warnings[0].number("most_rad"), 0.02);
  EXPECT_EQ(warnings[0].message,
            "the noise of the orientations correlates over 0.11 s, and the recording is 2 s long: the error may be "
            "anything from 0.29° to 1.1°; a recording of 2.2 s would tell it");
  smoothing.correlated_noise->time = 0.1;
  EXPECT_TRUE(warnings_of(smoothing).empty());
}

TEST(SmoothingResult, WarnsFirstOfSamplesThatAreFollowedBesideManyThatAreRejected) {
  Smoothing smoothing{.keys = std::vector<std::size_t>(200),
                      .stretches = {{0, 200}},
                      .rejected = {1, 50, 100},
                      .retained_outlier_runs = {60, 61}};
  smoothing.edge = LambdaChoice::Edge::longest;
  const auto warnings = warnings_of(smoothing);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0].code, "outliers_followed");
  EXPECT_EQ(warnings[0].where.key, 60u);
  EXPECT_EQ(warnings[0].number("samples"), 2.0);
  EXPECT_TRUE(warnings[0].message.starts_with("2 samples as far as the 3 that are rejected are followed as motion"))
      << warnings[0].message;
  smoothing.rejected = {1, 50};
  EXPECT_EQ(warnings_of(smoothing).front().code, "most_smoothing");
}

/// As a tag that is seen the wrong way round now and then: in one row of seven, to either side.
TEST(SmoothingResult, WarnsOfFlipsThatItFollowsAndHuberDoesNot) {
  Recording recording = recorded(400, degree);
  Dice dice(1);
  for (Eigen::Quaterniond& q : recording.noisy.orientations) {
    const double side = dice() < 0.5 ? -35.0 : 35.0;
    if (dice() < 1.0 / 7.0) q = q * exp<double>(Eigen::Vector3d(0.0, side * degree, 0.0));
  }
  const Smoothing plain = smoothed(recording.noisy), huber = smoothed(recording.noisy, {.loss = Loss::huber});
  EXPECT_LT(rms(huber, recording.clean), 0.5 * rms(plain, recording.clean));
  ASSERT_FALSE(plain.warnings.empty());
  EXPECT_EQ(plain.warnings.front().code, "outliers_followed");
  EXPECT_TRUE(huber.warnings.empty());
}

TEST(SmoothingResult, TellsOfSamplesThatJumpAndAreFollowed) {
  auto recording = recorded(40, degree);
  const auto jumps = [&](std::vector<std::size_t> retained) {
    return jumps_followed(Smoothing{.retained_outlier_runs = std::move(retained)},
                          Keyframes::make(recording.noisy).value());
  };
  EXPECT_FALSE(jumps({0, 9, 10, 11}));
  for (const std::size_t i : {10u, 11u})
    recording.noisy.orientations[i] = recording.noisy.orientations[i] * exp<double>(Eigen::Vector3d(0.0, 3.0, 0.0));
  const auto warning = jumps({9, 10, 11, 12});
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->code, "jumps_followed");
  EXPECT_EQ(warning->where.key, 10u);
  EXPECT_EQ(warning->number("samples"), 2.0);  // there and back
  EXPECT_FALSE(jumps({}));
}

TEST(SmoothingResult, SaysHowFarTheSamplesAre) {
  auto recording = recorded(400, degree);
  recording.noisy.orientations[200] = recording.noisy.orientations[200] * exp<double>(Eigen::Vector3d(0.0, 0.5, 0.0));
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value()).value();
  ASSERT_EQ(smoothing.rejected, std::vector<std::size_t>{200});
  double sum = 0.0, largest = 0.0, largest_accepted = 0.0;
  for (std::size_t i = 0; i < 400; ++i) {
    const double distance = angular_distance(smoothing.nodes.orientations[i], recording.noisy.orientations[i]);
    sum += distance * distance;
    largest = std::max(largest, distance);
    if (i != 200) largest_accepted = std::max(largest_accepted, distance);
  }
  EXPECT_NEAR(smoothing.distances.rms, std::sqrt(sum / 400.0), 1e-12);
  EXPECT_NEAR(smoothing.distances.largest, largest, 1e-12);
  EXPECT_NEAR(smoothing.accepted_distances.largest, largest_accepted, 1e-12);
  EXPECT_NEAR(smoothing.accepted_distances.rms, std::sqrt((sum - largest * largest) / 399.0), 1e-12);
}

TEST(SmoothingResult, WarnsOfTheChoiceBeforeWhatFollowsFromIt) {
  const auto warnings = warnings_of(Smoothing{.edge = LambdaChoice::Edge::longest, .last_step = 1e-3});
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].code, "most_smoothing");
  EXPECT_EQ(warnings[1].code, "unfinished");
  EXPECT_EQ(warnings[1].number("step_rad"), 1e-3);
}

TEST(SmoothingResult, BringsItsWarnings) {
  EXPECT_TRUE(two_stretches().warnings.empty());
  auto recording = recorded(600, 0.3 * degree);
  for (const std::size_t i : {300u, 301u, 302u, 303u, 304u, 305u, 306u})
    recording.noisy.orientations[i] = recording.noisy.orientations[i] * exp<double>(Eigen::Vector3d(0.5, 0.0, 0.0));
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value(), {.loss = Loss::tukey}).value();
  ASSERT_EQ(smoothing.warnings.size(), 2u);
  EXPECT_EQ(smoothing.warnings[1].code, "many_rejected");
  const Warning& warning = smoothing.warnings[0];
  const auto count = static_cast<std::size_t>(warning.number("samples"));
  EXPECT_EQ(warning.code, "rejected_run");
  EXPECT_GE(count, 7u);
  const auto is_rejected = [&](std::size_t i) { return std::ranges::binary_search(smoothing.rejected, i); };
  for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(is_rejected(*warning.where.key + i)) << i;
  EXPECT_FALSE(is_rejected(*warning.where.key - 1));
  EXPECT_FALSE(is_rejected(*warning.where.key + count));
}

}}  // namespace orispline
