// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/smooth.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

/// A slow swing with a jitter that changes its sign from key to key.
std::vector<double> jittery_swing() {
  std::vector<double> angles;
  for (int i = 0; i < 60; ++i) angles.push_back(std::sin(0.1 * i) + (i % 2 == 0 ? 0.01 : -0.01));
  return angles;
}

std::shared_ptr<const Track> recording_with_an_outlier() {
  auto angles = jittery_swing();
  angles[30] += 1.0;
  return turns(angles);
}

TEST(SmoothJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome = smooth({.recording = turns(jittery_swing()), .options = {.smoothing_time = 2.0}});
  ASSERT_TRUE(outcome);
  const Json document = document_of(*outcome);
  EXPECT_EQ(number(document, "smoothing_time_s"), 2.0);
  EXPECT_EQ(number(document, "largest_distance_rad"), outcome->smoothing.distances.largest);
  EXPECT_EQ(std::get<std::string>(member(document, "penalty").value()), "acceleration");
  EXPECT_EQ(std::get<std::string>(member(document, "loss").value()), "robust");
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(summary.starts_with("60 samples from data/arm.csv\nsmoothing time  2 s (cut-off ")) << summary;
  EXPECT_NE(summary.find("\nrejected        0\n"), std::string::npos) << summary;
  EXPECT_TRUE(line_of(*outcome).starts_with("60 keys from 60 samples, RMS ")) << line_of(*outcome);
}

TEST(SmoothJob, SaysWhatWasMendedAndHowManySamplesStandForTheKeys) {
  auto outcome = smooth({.recording = turns(jittery_swing()), .options = {.smoothing_time = 2.0}});
  ASSERT_TRUE(outcome);
  outcome->mended = "sorted 2 rows";
  outcome->samples = 1;
  EXPECT_EQ(outcome->result(), "1 sample");
  EXPECT_EQ(std::get<std::uint64_t>(member(document_of(*outcome), "rows_written").value()), 1);
  EXPECT_TRUE(summary_of(*outcome).starts_with("60 samples from data/arm.csv; sorted 2 rows\n"));
  EXPECT_TRUE(line_of(*outcome).starts_with("1 sample from 60 samples, "));
  EXPECT_TRUE(line_of(*outcome).ends_with("; sorted 2 rows"));
}

TEST(SmoothJob, NamesTheLinesOfWhatIsRejectedAndElseTheKeys) {
  const SmoothOptions options{.smoothing_time = 2.0};
  Track in_file = *recording_with_an_outlier();
  for (std::uint32_t line = 2; line < 62; ++line) in_file.lines.push_back(line);
  const auto of_file = smooth({.recording = std::make_shared<const Track>(in_file), .options = options});
  const auto of_keys = smooth({.recording = recording_with_an_outlier(), .options = options});
  ASSERT_TRUE(of_file && of_keys);
  EXPECT_NE(summary_of(*of_file).find("\nrejected        1: line 32 (30 s)\n"), std::string::npos)
      << summary_of(*of_file);
  EXPECT_NE(summary_of(*of_keys).find("\nrejected        1: key 30 (30 s)\n"), std::string::npos)
      << summary_of(*of_keys);
}

TEST(SmoothJob, SaysNothingOfRejectionWithoutIt) {
  const auto outcome =
      smooth({.recording = recording_with_an_outlier(), .options = {.smoothing_time = 2.0, .loss = Loss::l2}});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(summary_of(*outcome).find("rejected"), std::string::npos) << summary_of(*outcome);
}

TEST(SmoothJob, PutsErrorsInTheirPlace) {
  const auto outcome = smooth({.recording = turns({0.0, 1.0})});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().where.file, "data/arm.csv");
  const auto of_user = smooth({.recording = turns(jittery_swing()), .options = {.noise = 0.1, .smoothing_time = 2.0}});
  ASSERT_FALSE(of_user);
  EXPECT_TRUE(of_user.error().where.file.empty());
}

TEST(SmoothJob, StopsWhereItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  const auto outcome = smooth({.recording = turns(jittery_swing())}, {.stop = source.get_token()});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::cancelled);
}

}}  // namespace orispline::jobs
