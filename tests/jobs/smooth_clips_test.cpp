// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/smooth.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "jobs/swinging.hpp"
#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

/// Of an arm whose hand has too few keys.
SmoothClipsRequest wave(std::size_t clips = 1) {
  SmoothClipsRequest request{.name = "data/arm.glb",
                             .skeleton = *Skeleton::make({{.name = "arm"}, {.name = "hand", .parent = 0}}),
                             .options = {.smoothing_time = 2.0}};
  for (std::size_t i = 0; i < clips; ++i)
    request.clips.push_back({.name = "wave", .rotations = {swinging(0), swinging(1, 5)}});
  return request;
}

TEST(SmoothClipsJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome = smooth_clips(wave());
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->warnings.empty());
  const Json clip = std::get<Json::Array>(member(document_of(*outcome), "clips").value()).front();
  EXPECT_EQ(std::get<std::string>(member(clip, "clip").value()), "wave");
  const Json joint = std::get<Json::Array>(member(clip, "joints").value()).front();
  EXPECT_EQ(std::get<std::string>(member(joint, "joint").value()), "arm");
  EXPECT_EQ(number(joint, "smoothing_time_s"), 2.0);
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(
      summary.starts_with("1 rotation of 1 clip from data/arm.glb smoothed; 1 left as they are: they rest or "
                          "have too few keys\n  joint "))
      << summary;
  EXPECT_NE(summary.find("\n  arm "), std::string::npos) << summary;
  EXPECT_NE(summary.find("\nlargest change  "), std::string::npos) << summary;
}

TEST(SmoothClipsJob, AddsUpSeveralClipsAndNamesNoFileWhereThereIsNone) {
  SmoothClipsRequest request = wave(2);
  request.name.clear();
  const std::string summary = summary_of(*smooth_clips(std::move(request)));
  EXPECT_TRUE(summary.starts_with("2 rotations of 2 clips smoothed; 2 left as they are")) << summary;
  EXPECT_EQ(summary.find("\n  arm "), std::string::npos) << summary;
}

TEST(SmoothClipsJob, WarnsOnceOfAllThatCannotBeSmoothed) {
  SmoothClipsRequest request = wave(2);
  request.options.gap = 1.5;
  for (Clip& clip : request.clips)
    for (std::size_t i = 0; i < clip.rotations.front().size(); ++i)
      clip.rotations.front().times[i] += std::floor(static_cast<double>(i) / 2.0);
  const auto outcome = smooth_clips(std::move(request));
  ASSERT_TRUE(outcome) << outcome.error().message;
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings.front().code, "not_smoothed");
  EXPECT_TRUE(outcome->warnings.front().message.starts_with("left as it is what cannot be smoothed: 2 rotations; "))
      << outcome->warnings.front().message;
}

TEST(SmoothClipsJob, NamesTheFileInItsErrors) {
  SmoothClipsRequest request = wave();
  request.options.gyro = true;
  const auto outcome = smooth_clips(std::move(request));
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().where.file, "data/arm.glb");
}

}}  // namespace orispline::jobs
