// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_bytes.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/few_times.hpp>

namespace orispline { namespace {

using Keys = std::vector<std::size_t>;

VectorChannel moving(double (*height)(int)) {
  VectorChannel channel;
  for (int i = 0; i < 61; ++i) {
    channel.times.push_back(i / 30.0);
    channel.values.push_back({0.0, height(i), 0.0});
  }
  return channel;
}

double tent(int i) { return 0.01 * (i < 30 ? i : 60 - i); }
double saw(int i) { return i % 2 == 0 ? 0.0 : 0.1; }

KeyReach reach(const VectorChannel& channel) { return reach_of(channel, ChannelCurve<Eigen::Vector3d>(channel), 1e-3); }

TEST(FewTimes, AKeyReachesAsFarAsOneLineHolds) {
  const KeyReach of_tent = reach(moving(tent)), of_saw = reach(moving(saw));
  EXPECT_EQ(of_tent.last[0], 30u);
  EXPECT_EQ(of_tent.last[30], 60u);
  EXPECT_EQ(of_saw.last[7], 8u);
}

TEST(FewTimes, ChannelsShareTimesWhereThatIsLess) {
  const KeyReach of_tent = reach(moving(tent)), of_saw = reach(moving(saw));
  EXPECT_EQ(keys_at_few_times({of_tent}), (std::vector<Keys>{{0, 30, 60}}));
  const auto apart = keys_at_few_times({of_tent, of_saw, of_tent, of_saw});
  EXPECT_EQ(apart[0], (Keys{0, 30, 60}));
  EXPECT_EQ(apart[2], apart[0]);
  EXPECT_EQ(apart[1].size(), 61u);
  EXPECT_EQ(apart[3], apart[1]);
}

TEST(FewTimes, CompressedClipsAreWithinTheTolerance) {
  Clip clip{.name = "both", .translations = {moving(tent), moving(saw)}};
  clip.translations[1].joint = 1;
  const Skeleton skeleton = Skeleton::make({{.name = "a"}, {.name = "b"}}).value();
  ClipReduceOptions options{.position_tolerance = 1e-3,
                            .method = {smallest_method},
                            .precision = KeyPrecision::float32,
                            .compression = KeyCompression::meshopt};
  if (!has_meshopt()) GTEST_SKIP() << "this build is without meshoptimizer";
  const auto reduced = reduce_clips(skeleton, std::vector{clip}, options);
  ASSERT_TRUE(reduced);
  const ClipReduction& found = reduced->front();
  EXPECT_LE(found.translation.largest.value, 1e-3);
  EXPECT_GT(found.translation.largest.value, 0.0);
  EXPECT_EQ(found.clip.translations[0].size(), 3u);
  const std::size_t bytes = bytes_of_keys(found.clip, KeyCompression::meshopt);
  EXPECT_LT(bytes, bytes_of_keys(clip, KeyCompression::meshopt));
}

TEST(FewTimes, RotationsAreLinearForTheNextTool) {
  RotationChannel spline{.interpolation = ChannelInterpolation::cubicspline};
  for (int i = 0; i < 5; ++i) {
    spline.times.push_back(i);
    spline.values.push_back(Eigen::Quaterniond(Eigen::AngleAxisd(std::sin(i), Eigen::Vector3d::UnitX())));
    spline.in_tangents.push_back(Eigen::Quaterniond(0.0, 0.3 * std::cos(i), 0.0, 0.0));
  }
  spline.out_tangents = spline.in_tangents;
  const Clip clip{.name = "nod", .rotations = {spline}};
  const Skeleton skeleton = Skeleton::make({{.name = "a"}}).value();
  const auto reduced = reduce_clips(skeleton, std::vector{clip},
                                    {.tolerance = 0.01, .method = {"slerp"}, .next_tool = NextTool::meshopt});
  ASSERT_TRUE(reduced);
  EXPECT_EQ(reduced->front().clip.rotations[0].interpolation, ChannelInterpolation::linear);
  EXPECT_LE(reduced->front().angle.largest.value, 0.01);
  const auto refused = reduce_clips(skeleton, std::vector{clip}, {.tolerance = 0.01, .next_tool = NextTool::meshopt});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().option, "for");
}

}}  // namespace orispline
