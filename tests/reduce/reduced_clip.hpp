// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline::testing_support {

[[nodiscard]] inline ClipReduction reduced_clip(const Skeleton& skeleton, const Clip& clip,
                                                const ClipReduceOptions& options) {
  auto found = reduce_clips(skeleton, std::span(&clip, 1), options, 1);
  EXPECT_TRUE(found) << (found ? "" : describe(found.error()));
  return found ? found->front() : ClipReduction{.clip = clip};
}

}  // namespace orispline::testing_support
