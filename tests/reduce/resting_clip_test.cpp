// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include <orispline/clip/clip_motion.hpp>
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
  EXPECT_EQ(clip.rotations[0].size(), 1u);
  EXPECT_EQ(clip.rotations[1].size(), 2u);
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
    const auto reductions = reduce_clips(*skeleton, clips, {.tolerance = 0.01, .method = {method}});
    ASSERT_TRUE(reductions);
    const ClipReduction& reduction = reductions->front();
    EXPECT_LE(reduction.angle.largest.value, 0.01);
    EXPECT_LT(reduction.clip.rotations[0].size(), 20u);
    const ChannelCurve<Eigen::Quaterniond> curve(reduction.clip.rotations[0]);
    for (const double t : {0.6, 0.75, 1.0, 1.25, 1.4}) EXPECT_LE(curve.at(t).vec().norm(), 0.5 * 0.01) << method << t;
  }
}

}}  // namespace orispline
