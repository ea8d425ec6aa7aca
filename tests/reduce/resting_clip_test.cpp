// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline {
namespace {

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

}  // namespace
}  // namespace orispline
