// SPDX-License-Identifier: Apache-2.0
// Noise that correlates, without a gyro: stated, and found over several tracks. The noise is made here, and what is
// found is compared with it.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/smooth/clip_smoothing.hpp>
#include <orispline/smooth/correlated_fit.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

constexpr double interval = 0.01, sigma = 1.0 * degree;

/// A calm motion with first-order Markov noise of 1°; `time` 0: white.
Recording recorded_with(double time, std::uint64_t seed, std::size_t count = 600) {
  Recording recording = recorded(count, 0.0, seed);
  Dice dice(seed + 1000);
  const double kept = time > 0.0 ? std::exp(-interval / time) : 0.0;
  Eigen::Vector3d noise = normal_vector(dice);
  for (Eigen::Quaterniond& q : recording.noisy.orientations) {
    q = q * exp<double>(sigma * noise);
    noise = kept * noise + std::sqrt(1.0 - kept * kept) * normal_vector(dice);
  }
  return recording;
}

TEST(CorrelatedNoise, IsTakenAwayWhereItsTimeIsStated) {
  for (const double time : {0.02, 0.05, 0.1}) {
    SCOPED_TRACE(time);
    const Recording recording = recorded_with(time, 3);
    const Smoothing plain = smoothed(recording.noisy, {}), stated = smoothed(recording.noisy, {.noise_time = time});
    EXPECT_NEAR(stated.noise / sigma, 1.0, 0.2);
    ASSERT_TRUE(stated.correlated_noise);
    EXPECT_EQ(stated.correlated_noise->time, time);
    EXPECT_EQ(stated.correlated_noise->sigma, stated.noise);
    EXPECT_LT(rms(stated, recording.clean), 0.9 * rms(plain, recording.clean));
    EXPECT_FALSE(stated.hidden_noise);
  }
}

TEST(CorrelatedNoise, IsAsLargeAsItIsSaidThatItCouldBe) {
  const Recording recording = recorded_with(0.1, 5);
  const Smoothing plain = smoothed(recording.noisy, {});
  ASSERT_TRUE(plain.hidden_noise);
  EXPECT_NEAR(plain.hidden_noise->time, 0.1, 1e-9);
  EXPECT_LT(plain.noise, 0.6 * sigma) << "it looks like motion";
  EXPECT_NEAR(plain.hidden_noise->sigma / sigma, 1.0, 0.2);
  EXPECT_FALSE(smoothed(recording.noisy, {.noise = sigma}).hidden_noise) << "it is stated";
}

TEST(CorrelatedNoise, IsKnownToTheStandardDeviations) {
  const Recording recording = recorded_with(0.05, 7);
  const Smoothing smoothing = smoothed(recording.noisy, {.noise = sigma, .noise_time = 0.05, .sigma = true});
  const double said = *smoothing.rms_sigma() * std::sqrt(3.0), off = rms(smoothing, recording.clean);
  EXPECT_GT(said, 0.6 * off);
  EXPECT_LT(said, 1.6 * off);
}

/// The time within which the noise of joints of a clip correlates [s]; absent where it is white.
std::optional<double> time_of_joints(const std::vector<KeyframeData>& tracks) {
  std::vector<Joint> joints;
  Clip clip{.name = "walk"};
  for (const KeyframeData& track : tracks) {
    clip.rotations.push_back({.joint = joints.size(), .times = track.times, .values = track.orientations});
    joints.push_back({.name = std::to_string(joints.size())});
  }
  const auto found = smooth_clips(Skeleton::make(joints).value(), std::vector{clip}, {}, 1).value();
  const auto& noise = found.front().joints.front().smoothing.correlated_noise;
  return noise ? std::optional(noise->time) : std::nullopt;
}

TEST(CorrelatedNoise, OfJointsIsFoundAndWhiteNoiseIsNot) {
  for (const double time : {0.0, 0.05}) {
    SCOPED_TRACE(time);
    std::vector<KeyframeData> tracks;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) tracks.push_back(recorded_with(time, seed).noisy);
    const auto found = time_of_joints(tracks);
    ASSERT_EQ(found.has_value(), time > 0.0);
    EXPECT_FALSE(time_of_joints({tracks.front()})) << "one track does not tell";
    if (!found) continue;
    EXPECT_LT(*found, 1.5 * time);
    EXPECT_GT(*found, 0.3 * time) << "rather too short than too long";
  }
}

TEST(CorrelatedNoise, OfJointsIsFoundBesideOneThatRests) {
  std::vector<KeyframeData> tracks;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) tracks.push_back(recorded_with(0.05, seed).noisy);
  for (const double rate : {0.0, 0.3}) {
    Recording quiet = recorded(600, 0.3 * sigma, 7);  // of which samples at either end show noise
    auto& orientations = quiet.noisy.orientations;
    for (std::size_t i = 90; i < 510; ++i)
      orientations[i] =
          orientations[89] * exp<double>(rate * interval * static_cast<double>(i) * Eigen::Vector3d::UnitX());
    std::vector<KeyframeData> with = tracks;
    with.push_back(quiet.noisy);
    const auto found = time_of_joints(with);
    ASSERT_TRUE(found) << rate;
    EXPECT_LT(*found, 0.075) << rate;
    EXPECT_GT(*found, 0.015) << rate;
  }
}

TEST(CorrelatedNoise, IsStatedWithoutWhatContradictsIt) {
  EXPECT_FALSE(check(SmoothOptions{.noise_time = 0.05, .smoothing_time = 0.1}));
  EXPECT_FALSE(check(SmoothOptions{.noise_time = 0.05, .gyro = true}));
  EXPECT_FALSE(check(SmoothOptions{.noise_time = 0.0}));
  EXPECT_TRUE(check(SmoothOptions{.noise = 0.01, .noise_time = 0.05}));
}

TEST(CorrelatedNoise, LastsNoLongerThanAQuarterOfTheRecording) {
  const Track track(Keyframes::make(recorded_with(0.05, 3, 201).noisy).value());
  EXPECT_TRUE(smooth(track, {.noise_time = 0.49}));
  const auto refused = smooth(track, {.noise_time = 0.51});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().option, "noise_time");
  EXPECT_EQ(refused.error().message.find("found 0.51 s, wanted at most 0.5 s, a quarter of the recording"), 0u)
      << refused.error().message;
}

TEST(CorrelatedNoise, IsLeftAsideByChannelsThatAreTooShortForIt) {
  const Skeleton skeleton = Skeleton::make({{.name = "long"}, {.name = "short"}}).value();
  Clip clip{.name = "walk"};
  for (const std::size_t count : {401u, 101u}) {
    const Recording recording = recorded_with(0.05, 3 + count, count);
    clip.rotations.push_back(
        {.joint = clip.rotations.size(), .times = recording.noisy.times, .values = recording.noisy.orientations});
  }
  const std::vector<Clip> clips{clip};
  const auto found = smooth_clips(skeleton, clips, {.noise_time = 0.5}, 1);
  ASSERT_TRUE(found) << describe(found.error());
  ASSERT_EQ(found->front().joints.size(), 2u);
  EXPECT_TRUE(found->front().joints[0].smoothing.correlated_noise);
  EXPECT_FALSE(found->front().joints[1].smoothing.correlated_noise);
  const auto refused = smooth_clips(skeleton, clips, {.noise_time = 1.01}, 1);
  ASSERT_FALSE(refused) << "no channel can have it";
  EXPECT_EQ(refused.error().option, "noise_time");
}

}}  // namespace orispline
