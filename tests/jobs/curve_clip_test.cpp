// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/curve_clip.hpp>

#include <gtest/gtest.h>

#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

PoseCurve curve() { return shaped_curve("auto", *turns({0.0, 1.0, 1.5, 3.0})).value(); }

CurveClipRequest request(std::optional<double> tolerance, std::vector<double> times = {}) {
  return {.name = "arm",
          .source = "data/arm.csv",
          .method = "auto",
          .keys = 4,
          .tolerance = tolerance,
          .position_tolerance = 0.01,
          .sample_times = std::move(times)};
}

TEST(CurveClipJob, KeepsCubicsWithinTheToleranceAsTheyAreReadAgain) {
  const CurveClipOutcome outcome = curve_clip(request(1e-4), curve());
  const RotationChannel& channel = outcome.clip.rotations.at(0);
  EXPECT_EQ(channel.interpolation, ChannelInterpolation::cubicspline);
  EXPECT_EQ(outcome.clip.name, "arm");
  EXPECT_LE(outcome.largest, 1e-4);
  EXPECT_GE(outcome.largest, largest_distance(curve().orientation, in_single_precision(channel)));
  EXPECT_TRUE(outcome.warnings.empty());
}

TEST(CurveClipJob, WarnsWhereSinglePrecisionIsTooCoarse) {
  const CurveClipOutcome outcome = curve_clip(request(1e-9), curve());
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_EQ(outcome.warnings[0].code, "beyond_tolerance");
  EXPECT_EQ(outcome.warnings[0].option, "tolerance");
  EXPECT_GT(outcome.largest, 1e-9);
}

TEST(CurveClipJob, TakesSamplesWhereNoToleranceIsAsked) {
  const CurveClipOutcome outcome = curve_clip(request({}, {0.0, 0.25, 3.0}), curve());
  const RotationChannel& channel = outcome.clip.rotations.at(0);
  EXPECT_EQ(channel.times, (std::vector{0.0, 0.25, 3.0}));
  EXPECT_EQ(channel.values[1].coeffs(), curve().orientation(0.25).normalized().coeffs());
  EXPECT_EQ(count(document_of(outcome), "keys_written"), 3u);
}

TEST(CurveClipJob, SaysTheSameInItsDocumentAndItsSummary) {
  CurveClipOutcome outcome = curve_clip(request(1e-4), curve());
  outcome.written_to = "arm.glb";
  EXPECT_EQ(count(document_of(outcome), "keys"), 4u);
  EXPECT_EQ(count(document_of(outcome), "keys_written"), outcome.clip.rotations.at(0).size());
  const std::string summary = summary_of(outcome);
  EXPECT_TRUE(summary.starts_with("4 keys from data/arm.csv, auto\n")) << summary;
  EXPECT_TRUE(summary.ends_with("written to arm.glb as cubics\n")) << summary;
}

}}  // namespace orispline::jobs
