// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { namespace {

TEST(ReduceClips, LeavesAClipThatRestsAsLongAsItWas) {
  const auto skeleton = Skeleton::make({{.name = "a"}, {.name = "b"}});
  ASSERT_TRUE(skeleton);
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  const std::array clips{Clip{.name = "rest",
                              .rotations = {{.joint = 0, .times = {0.0, 1.0, 2.0}, .values = {still, still, still}},
                                            {.joint = 1, .times = {0.0, 3.0}, .values = {still, still}}}}};
  const auto reductions = reduce_clips(*skeleton, clips, {.tolerance = 0.01});
  ASSERT_TRUE(reductions);
  const Clip& clip = reductions->front().clip;
  EXPECT_EQ(clip.domain().end, 3.0);
  ASSERT_EQ(clip.rotations.size(), 1u);
  EXPECT_EQ(clip.rotations[0].joint, 1u);
  EXPECT_EQ(clip.rotations[0].size(), 2u);
  const auto kept = reduce_clips(*skeleton, clips, {.tolerance = 0.01, .keep_constant = true});
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->front().clip.rotations.size(), 2u);
  EXPECT_EQ(kept->front().clip.rotations[0].size(), 1u);
}

/// A joint that turns, and two that rest: one as its rest pose says, one elsewhere.
Clip with_two_at_rest() {
  RotationChannel turn{.joint = 0}, rest{.joint = 1}, elsewhere{.joint = 2};
  for (int i = 0; i <= 30; ++i) {
    for (RotationChannel* const channel : {&turn, &rest, &elsewhere}) channel->times.push_back(i / 30.0);
    turn.values.push_back(exp<double>(Eigen::Vector3d(std::sin(0.1 * i), 0.0, 0.0)));
    rest.values.push_back(Eigen::Quaterniond::Identity());
    elsewhere.values.push_back(exp<double>(Eigen::Vector3d(0.0, 0.5, 0.0)));
  }
  VectorChannel still{.joint = 0, .times = {0.0}, .values = {Eigen::Vector3d::Zero()}};
  return {.name = "nod", .rotations = {turn, rest, elsewhere}, .translations = {still}};
}

TEST(ReduceClips, LeavesOutChannelsThatTheRestPoseStandsFor) {
  const auto skeleton = Skeleton::make({{.name = "a"}, {.name = "b"}, {.name = "c"}});
  ASSERT_TRUE(skeleton);
  const std::array clips{with_two_at_rest()};
  const ClipReduction without = reduce_clips(*skeleton, clips, {.tolerance = 1e-3}).value().front();
  const ClipReduction with = reduce_clips(*skeleton, clips, {.tolerance = 1e-3, .keep_constant = true}).value().front();
  EXPECT_EQ(without.tracks_before, 4u);
  EXPECT_EQ(without.tracks_left_out, 2u);
  EXPECT_EQ(with.tracks_left_out, 0u);
  ASSERT_EQ(without.clip.rotations.size(), 2u);
  EXPECT_EQ(without.clip.rotations[0].joint, 0u);
  EXPECT_EQ(without.clip.rotations[1].joint, 2u);
  EXPECT_EQ(without.clip.rotations[1].size(), 1u);
  EXPECT_TRUE(without.clip.translations.empty());
  EXPECT_EQ(without.rotation_keys + 1, with.rotation_keys);
  EXPECT_EQ(without.translation_keys, 0u);
  EXPECT_EQ(with.translation_keys, 1u);
  const auto poses = world_poses(*skeleton, without.clip, std::array{0.0, 0.4}),
             kept = world_poses(*skeleton, with.clip, std::array{0.0, 0.4});
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(poses[i].matrix(), kept[i].matrix());
}

TEST(ReduceClips, KeepsAChannelWhereAllRestAndThatWhichBeginsTheClip) {
  const auto skeleton = Skeleton::make({{.name = "a"}, {.name = "b"}});
  ASSERT_TRUE(skeleton);
  const Eigen::Quaterniond still = Eigen::Quaterniond::Identity();
  const RotationChannel first{.joint = 0, .times = {0.0}, .values = {still}},
      second{.joint = 1, .times = {0.0}, .values = {still}};
  const std::array resting{Clip{.name = "pose", .rotations = {first, second}}};
  const ClipReduction pose = reduce_clips(*skeleton, resting, {.tolerance = 0.01}).value().front();
  ASSERT_EQ(pose.clip.rotations.size(), 1u);
  EXPECT_EQ(pose.clip.rotations[0].joint, 0u);
  EXPECT_EQ(pose.tracks_left_out, 1u);
  RotationChannel late{.joint = 1};
  for (int i = 0; i <= 30; ++i) {
    late.times.push_back(1.0 + i / 30.0);
    late.values.push_back(exp<double>(Eigen::Vector3d(std::sin(0.1 * i), 0.0, 0.0)));
  }
  const std::array clips{Clip{.name = "late", .rotations = {first, late}}};
  const ClipReduction found = reduce_clips(*skeleton, clips, {.tolerance = 0.01}).value().front();
  EXPECT_EQ(found.clip.domain().start, 0.0);
  EXPECT_EQ(found.clip.rotations.size(), 2u);
}

/// 40° to and fro in half a second, then a rest of a second without a key, and the same again.
RotationChannel with_rest(std::size_t joint) {
  RotationChannel channel{.joint = joint};
  for (const double start : {0.0, 1.5})
    for (int i = 0; i <= 15; ++i) {
      const double phase = 2.0 * std::numbers::pi * i / 15.0;
      channel.times.push_back(start + i / 30.0);
      channel.values.push_back(exp<double>(Eigen::Vector3d(0.7 * std::sin(phase), 0.0, 0.0)));
    }
  channel.values[15] = channel.values[16] = channel.values[0];
  return channel;
}

TEST(ReduceClips, StandsStillBetweenEqualKeysAndIsJudgedAtTheKeysOfEachJoint) {
  const auto skeleton = Skeleton::make({{.name = "a"}, {.name = "b"}});
  ASSERT_TRUE(skeleton);
  RotationChannel other{.joint = 1};
  for (int i = 0; i <= 200; ++i) {
    other.times.push_back(0.01 * i);
    other.values.push_back(exp<double>(Eigen::Vector3d(0.0, std::sin(0.05 * i), 0.0)));
  }
  const std::array clips{Clip{.name = "swing", .rotations = {with_rest(0), other}}};
  for (const char* method : {"cubicspline", "hermite-c1"}) {
    const auto reductions =
        reduce_clips(*skeleton, clips, {.tolerance = 0.01, .method = {method}, .between = BetweenSamples::smooth});
    ASSERT_TRUE(reductions);
    const ClipReduction& reduction = reductions->front();
    EXPECT_LE(reduction.angle.largest.value, 0.01);
    EXPECT_LT(reduction.clip.rotations[0].size(), 20u);
    const ChannelCurve<Eigen::Quaterniond> curve(reduction.clip.rotations[0]);
    for (const double t : {0.6, 0.75, 1.0, 1.25, 1.4}) EXPECT_LE(curve.at(t).vec().norm(), 0.5 * 0.01) << method << t;
  }
}

/// Two joints, the second in a frame that a scale makes longer, which move by less than the rounding of files.
Skeleton stretched(double scale) {
  JointPose grown;
  grown.scale = Eigen::Vector3d::Constant(scale);
  return Skeleton::make({{.name = "grown", .rest = grown}, {.name = "tip", .parent = 0}}).value();
}

/// Every property of the tip moves to and fro by a part of what counts as rest.
Clip trembling(double part) {
  RotationChannel turn{.joint = 1};
  VectorChannel shift{.joint = 1}, growth{.joint = 1};
  for (int i = 0; i <= 60; ++i) {
    const double wave = part * std::sin(0.3 * i);
    for (auto* const times : {&turn.times, &shift.times, &growth.times}) times->push_back(i / 30.0);
    turn.values.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, rest_angle * wave)));
    shift.values.emplace_back(0.0, rest_length * wave, 0.0);
    growth.values.emplace_back(Eigen::Vector3d::Constant(1.0 + rest_length * wave));
  }
  return {.name = "tremble", .rotations = {turn}, .translations = {shift}, .scales = {growth}};
}

ClipReduction reduced_tremble(ClipReduceOptions options, double scale = 1.0) {
  options.keep_constant = true;
  return reduce_clips(stretched(scale), std::array{trembling(0.5)}, options).value().front();
}

TEST(ReduceClips, ABoundHoldsForWhatNearlyRestsToo) {
  for (const KeyPrecision precision : {KeyPrecision::float64, KeyPrecision::float32}) {
    const ClipReduction loose =
        reduced_tremble({.tolerance = 1e-3, .position_tolerance = 1e-3, .precision = precision});
    EXPECT_EQ(loose.clip.rotations[0].size() + loose.clip.translations[0].size() + loose.clip.scales[0].size(), 4u)
        << "one of them keeps the end of the clip";
    for (const double part : {0.3, 0.03}) {
      const double angle = part * rest_angle, length = part * rest_length;
      const ClipReduction tight =
          reduced_tremble({.tolerance = angle, .position_tolerance = length, .precision = precision});
      EXPECT_LE(tight.angle.largest.value, angle);
      EXPECT_LE(tight.translation.largest.value, length);
      EXPECT_GT(tight.clip.rotations[0].size(), 2u);
      EXPECT_GT(tight.clip.translations[0].size(), 2u);
    }
  }
}

TEST(ReduceClips, ABoundInTheWorldHoldsForWhatNearlyRestsToo) {
  for (const double scale : {1.0, 1000.0}) {
    for (const double length : {1e-5 * scale, 1e-7 * scale, 1e-8 * scale}) {
      const ClipReduction found = reduced_tremble({.world_tolerance = length}, scale);
      EXPECT_LE(found.distance.largest.value, length) << scale;
    }
  }
}

TEST(ReduceClips, WhatNearlyRestsIsJudgedInTheWorldWhereNothingBoundsIt) {
  EXPECT_EQ(reduced_tremble({.tolerance = 1e-3}).clip.translations[0].size(), 1u);
  const ClipReduction found = reduced_tremble({.tolerance = 1e-3}, 1000.0);
  EXPECT_EQ(found.clip.translations[0].size(), 61u);
  EXPECT_EQ(found.translation.largest.value, 0.0);
}

TEST(ReduceClips, AScaleThatIsSmallRestsByItsOwnSize) {
  VectorChannel growth{.joint = 0, .times = {0.0, 1.0, 2.0}};
  for (const double scale : {1.0, 1.5, 1.0}) growth.values.emplace_back(Eigen::Vector3d::Constant(1e-7 * scale));
  const Clip clip{.name = "speck", .scales = {growth}};
  const auto found = reduce_clips(stretched(1e-7), std::array{clip}, {.tolerance = 1e-3});
  EXPECT_EQ(found.value().front().clip.scales[0].size(), 3u);
}

TEST(ReduceClips, HasNoLargestErrorWhereNothingMoves) {
  const Clip empty{.name = "nothing"};
  for (const Skeleton& skeleton : {Skeleton(), stretched(1.0)})
    for (const ClipReduceOptions& options : {ClipReduceOptions{.tolerance = 1e-3}, {.world_tolerance = 1e-3}}) {
      const auto found = reduce_clips(skeleton, std::array{empty, empty}, options);
      ASSERT_TRUE(found);
      ASSERT_EQ(found->size(), 2u);
      for (const ClipReduction& reduction : *found)
        for (const auto* const worst : {&reduction.angle, &reduction.translation, &reduction.distance,
                                        &reduction.from_smooth, &reduction.from_stored})
          EXPECT_FALSE(worst->is_known());
    }
}

}}  // namespace orispline
