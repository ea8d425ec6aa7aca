// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/retime/clip_retiming.hpp>

namespace orispline { namespace {

constexpr double pi = std::numbers::pi;

Skeleton arm() { return Skeleton::make({{.name = "arm"}, {.name = "hand", .parent = 0}}).value(); }

/// A joint that turns about z by `angle` cos(2πt) over two seconds, at 30 frames a second.
RotationChannel swing(std::size_t joint, double angle) {
  RotationChannel channel{.joint = joint};
  for (int i = 0; i <= 60; ++i) {
    channel.times.push_back(i / 30.0);
    channel.values.emplace_back(Eigen::AngleAxisd(angle * std::cos(2.0 * pi * i / 30.0), Eigen::Vector3d::UnitZ()));
  }
  return channel;
}

ClipRetiming slowed(const Clip& clip, const RetimeOptions& options) {
  return retime_clip(arm(), clip, Method("auto"), options).value();
}

TEST(ClipRetiming, SlowsAllJointsByTheOneThatIsFastest) {
  const Clip clip{.name = "wave", .rotations = {swing(0, 0.1), swing(1, 0.5)}};
  const double fastest = 0.5 * 2.0 * pi;  // [rad/s]
  const ClipRetiming made = slowed(clip, {.limits = {.rate = Limit(0.5 * fastest)}});
  EXPECT_NEAR(made.time_scale, 2.0, 2e-3);
  ASSERT_EQ(made.clip.rotations.size(), 2U);
  for (const RotationChannel& channel : made.clip.rotations) {
    EXPECT_NEAR(channel.times.back(), 2.0 * made.time_scale, 1e-12);
    EXPECT_TRUE(channel.times == made.clip.rotations[0].times);
  }
  const auto certificates = certificates_of({.rate = Limit(0.5 * fastest)}, made.peaks);
  EXPECT_LE(certificates[0].bound, 0.5 * fastest);
  EXPECT_EQ(certificates[0].body, 1U);
  EXPECT_EQ(slowed(clip, {.limits = {.rate = Limit(2.0 * fastest)}}).time_scale, 1.0);
}

TEST(ClipRetiming, GivesIntervalsTimesOfTheirOwnThatAllJointsShare) {
  Clip clip{.name = "wave", .rotations = {swing(0, 0.1), swing(1, 0.02)}};
  for (std::size_t i = 40; i < 50; ++i)  // the hand turns fast here
    clip.rotations[1].values[i] =
        Eigen::AngleAxisd(0.1 * static_cast<double>(i - 40), Eigen::Vector3d::UnitX()) * clip.rotations[1].values[i];
  RetimeOptions options{.limits = {.rate = Limit(1.0)}};
  const double alike = slowed(clip, options).time_scale;
  options.slowing = Slowing::per_interval;
  const ClipRetiming made = slowed(clip, options);
  EXPECT_EQ(made.slowing, Slowing::per_interval);
  EXPECT_LT(made.time_scale, 0.9 * alike);
  EXPECT_TRUE(made.clip.rotations[0].times == made.clip.rotations[1].times);
  EXPECT_TRUE(made.clip.rotations[0].values == clip.rotations[0].values);
  EXPECT_LE(certificates_of(options.limits, made.peaks)[0].bound, 1.0);
}

TEST(ClipRetiming, ScalesEveryChannelToADuration) {
  VectorChannel step{.joint = 0,
                     .interpolation = ChannelInterpolation::step,
                     .times = {0.5, 1.5},
                     .values = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  VectorChannel cubic{.joint = 1,
                      .interpolation = ChannelInterpolation::cubicspline,
                      .times = {0.0, 1.0},
                      .values = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()},
                      .in_tangents = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()},
                      .out_tangents = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero()}};
  const Clip clip{.name = "wave", .rotations = {swing(0, 0.1)}, .translations = {step, cubic}};
  const ClipRetiming made = slowed(clip, {.duration = 3.0});
  EXPECT_EQ(made.clip.domain().end, 3.0);
  EXPECT_DOUBLE_EQ(made.clip.translations[0].times[1], 2.25);
  for (const double t : {0.2, 0.7})
    EXPECT_LE((ChannelCurve<Eigen::Vector3d>(made.clip.translations[1]).at(1.5 * t) -
               ChannelCurve<Eigen::Vector3d>(cubic).at(t))
                  .norm(),
              1e-15);
  EXPECT_EQ(made.measured, 1U);
}

TEST(ClipRetiming, MeasuresCubicsAndSaysSo) {
  RotationChannel cubic{.joint = 1, .interpolation = ChannelInterpolation::cubicspline, .times = {0.0, 1.0}};
  for (const double angle : {0.0, 1.0}) {
    cubic.values.emplace_back(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    cubic.in_tangents.emplace_back(0.0, 0.0, 0.0, 0.0);
    cubic.out_tangents.emplace_back(0.0, 0.0, 0.0, 0.0);
  }
  const ClipRetiming made =
      slowed({.name = "wave", .rotations = {swing(0, 0.01), cubic}}, {.limits = {.rate = Limit(0.5)}});
  EXPECT_GT(made.time_scale, 2.5);
  ASSERT_EQ(made.warnings.size(), 1U);
  EXPECT_EQ(made.warnings[0].code, "measured_peaks");
}

TEST(ClipRetiming, RefusesWhatAClipHasNoRoomFor) {
  const Clip clip{.name = "wave", .rotations = {swing(0, 0.1)}};
  RetimeOptions even{.constant_rate = 1.0};
  const auto refused = [&](const RetimeOptions& options, const Clip& of) {
    return describe(retime_clip(arm(), of, Method("auto"), options).error());
  };
  EXPECT_EQ(refused(even, clip), "constant_rate: found a skeleton, wanted the keys of one track");
  EXPECT_EQ(refused({.duration = 1.0}, {.name = "rest"}), "clip 'rest': found no channel of two keys, wanted one");
  Clip apart{.name = "wave", .rotations = {swing(0, 0.1), swing(1, 0.1)}};
  apart.rotations[1].times[3] += 0.01;
  EXPECT_EQ(refused({.limits = {.rate = Limit(0.1)}, .slowing = Slowing::per_interval}, apart),
            "slowing: clip 'wave': found channels with keys at different times or cubics, wanted linear ones with the "
            "same times, as `sample` with a rate writes them");
}

}}  // namespace orispline
