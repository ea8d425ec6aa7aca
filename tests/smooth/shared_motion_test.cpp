// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/shared_motion.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/smooth/clip_smoothing.hpp>

namespace orispline { namespace {

constexpr Eigen::Index time_count = 400;
constexpr std::size_t joint_count = 8;

using Normal = std::normal_distribution<double>;

/// Eight joints that swing as two hidden ones do: each channel is a combination of these.
Eigen::MatrixXd swings(std::mt19937& random) {
  Normal normal;
  Eigen::MatrixXd hidden(time_count, 2), mixed(2, static_cast<Eigen::Index>(3 * joint_count));
  for (Eigen::Index i = 0; i < time_count; ++i) {
    const double t = static_cast<double>(i) / 120.0;
    hidden(i, 0) = std::sin(2.0 * std::numbers::pi * 1.1 * t) + 0.3 * std::sin(2.0 * std::numbers::pi * 3.3 * t);
    hidden(i, 1) = std::cos(2.0 * std::numbers::pi * 0.7 * t + 0.3) + 0.2 * std::cos(2.0 * std::numbers::pi * 4.1 * t);
  }
  for (double& value : mixed.reshaped()) value = 0.1 * normal(random);
  return hidden * mixed;
}

/// First-order Markov noise; white where nothing is kept from time to time.
Eigen::MatrixXd noise(std::mt19937& random, double sigma, double kept) {
  Normal normal;
  Eigen::MatrixXd values(time_count, static_cast<Eigen::Index>(3 * joint_count));
  for (Eigen::Index c = 0; c < values.cols(); ++c)
    for (Eigen::Index i = 0; i < time_count; ++i)
      values(i, c) = i == 0 ? sigma * normal(random)
                            : kept * values(i - 1, c) + sigma * std::sqrt(1.0 - kept * kept) * normal(random);
  return values;
}

Channels channels_of(Eigen::MatrixXd values) {
  Channels channels{.values = std::move(values)};
  for (std::size_t c = 0; c < 3 * joint_count; ++c) channels.joints.push_back(c / 3), channels.kinds.push_back(0);
  return channels;
}

double rms(const Eigen::MatrixXd& difference) {
  return std::sqrt(difference.squaredNorm() / static_cast<double>(difference.size()));
}

TEST(SharedMotion, TellsWhiteNoiseAndTakesMoreOfItThanChannelsAlone) {
  std::mt19937 random(3);
  const Eigen::MatrixXd truth = swings(random);
  Eigen::MatrixXd off = noise(random, 0.01, 0.0);
  off.leftCols(3) *= 3.0;  // one joint is noisier
  const Channels channels = channels_of(truth + off);
  const SharedMotion motion = shared_motion(channels, {.sigmas = {std::nullopt}});
  EXPECT_EQ(motion.noise_time, 0.0);
  for (Eigen::Index c = 0; c < motion.sigmas.size(); ++c)
    EXPECT_NEAR(motion.sigmas[c] / (c < 3 ? 0.03 : 0.01), 1.0, 0.15) << c;
  const double together = rms(smoothed_channels(channels, motion) - truth);
  SharedMotion alone = motion;
  alone.directions.setIdentity();
  for (Eigen::Index c = 0; c < alone.strengths.size(); ++c) alone.strengths[c] = 1.0 / lambda_alone(motion, c);
  EXPECT_LT(together, 0.8 * rms(smoothed_channels(channels, alone) - truth));
  EXPECT_LT(together, 0.5 * rms(off));
}

TEST(SharedMotion, TellsNoiseThatCorrelates) {
  std::mt19937 random(5);
  const Eigen::MatrixXd truth = swings(random), off = noise(random, 0.01, std::exp(-1.0 / 6.0));
  const Channels channels = channels_of(truth + off);
  const auto error_of = [&](const SharedMotion& motion) { return rms(smoothed_channels(channels, motion) - truth); };
  const SharedMotion motion = shared_motion(channels, {.sigmas = {std::nullopt}});
  EXPECT_GT(motion.noise_time, 0.0);
  EXPECT_LE(motion.noise_time, 9.6) << "rather too short than too long";
  EXPECT_LT(error_of(motion), 0.95 * error_of(shared_motion(channels, {.time = 0.0, .sigmas = {std::nullopt}})));
  const SharedMotion stated = shared_motion(channels, {.time = 6.0, .sigmas = {std::nullopt}});
  EXPECT_NEAR(rms(stated.sigmas), 0.01, 0.001);
  EXPECT_LT(error_of(stated), error_of(motion));
}

TEST(SharedMotion, TakesWhatIsKnownOfTheNoise) {
  std::mt19937 random(7);
  const Channels channels = channels_of(swings(random) + noise(random, 0.01, 0.0));
  const SharedMotion motion = shared_motion(channels, {.time = 4.0, .sigmas = {0.02}});
  EXPECT_EQ(motion.noise_time, 4.0);
  for (const double sigma : motion.sigmas) EXPECT_EQ(sigma, 0.02);
}

TEST(SharedMotion, LeavesAMotionWithoutNoiseAsItIs) {
  std::mt19937 random(9);
  const Eigen::MatrixXd truth = swings(random);
  const Channels channels = channels_of(truth);
  const SharedMotion motion = shared_motion(channels, {.sigmas = {std::nullopt}});
  EXPECT_LT(rms(smoothed_channels(channels, motion) - truth), 1e-3 * rms(truth));
}

/// The swings about a turn of their own each, at 120 Hz.
Clip clip_of(const Eigen::MatrixXd& values) {
  Clip clip{.name = "swing"};
  for (std::size_t joint = 0; joint < joint_count; ++joint) {
    RotationChannel& channel = clip.rotations.emplace_back(RotationChannel{.joint = joint});
    for (Eigen::Index i = 0; i < time_count; ++i) {
      channel.times.push_back(static_cast<double>(i) / 120.0);
      channel.values.push_back(exp<double>({0.2 * static_cast<double>(joint), 0.4, 0.0}) *
                               exp<double>(values.row(i).segment<3>(static_cast<Eigen::Index>(3 * joint)).transpose()));
    }
  }
  return clip;
}

double rms(const Clip& clip, const Clip& truth) {
  double sum = 0.0;
  for (std::size_t j = 0; j < joint_count; ++j)
    for (std::size_t i = 0; i < clip.rotations[j].size(); ++i)
      sum += std::pow(angular_distance(clip.rotations[j].values[i], truth.rotations[j].values[i]), 2);
  return std::sqrt(sum / static_cast<double>(3 * joint_count * time_count));
}

TEST(SmoothClips, SmoothsJointsThatMoveTogetherBetterThanOneByOne) {
  std::mt19937 random(11);
  const Eigen::MatrixXd swing = swings(random);
  const Clip truth = clip_of(swing), noisy = clip_of(swing + noise(random, 0.01, 0.0));
  const Skeleton skeleton = [] {
    std::vector<Joint> all{{.name = "0"}};
    for (std::size_t j = 1; j < joint_count; ++j) all.push_back({.name = std::to_string(j), .parent = 0});
    return Skeleton::make(std::move(all)).value();
  }();
  const auto together = smooth_clips(skeleton, std::vector{noisy});
  ASSERT_TRUE(together) << describe(together.error());
  double alone = 0.0;
  for (std::size_t j = 0; j < joint_count; ++j) {
    Clip one{.name = "one", .rotations = {noisy.rotations[j]}};
    const auto smoothed = smooth_clips(skeleton, std::vector{one});
    ASSERT_TRUE(smoothed);
    for (std::size_t i = 0; i < static_cast<std::size_t>(time_count); ++i)
      alone +=
          std::pow(angular_distance(smoothed->front().clip.rotations[0].values[i], truth.rotations[j].values[i]), 2);
  }
  EXPECT_LT(rms(together->front().clip, truth),
            0.9 * std::sqrt(alone / static_cast<double>(3 * joint_count * time_count)));
  for (const auto& joint : together->front().joints) {
    EXPECT_NEAR(joint.smoothing.noise, 0.01, 0.0015);
    EXPECT_GT(joint.smoothing.smoothing_time, 0.0);
  }
}

}}  // namespace orispline
