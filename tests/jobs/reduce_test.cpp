// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/reduce.hpp>

#include <cmath>
#include <stop_token>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

constexpr double tolerance = 0.02;  // [rad]

/// A swing with a jitter of 0.005 rad, one sample of which is far off.
std::vector<double> noisy_angles() {
  std::vector<double> angles;
  for (int i = 0; i < 80; ++i) angles.push_back(std::sin(0.05 * i) + 0.005 * std::sin(2.3 * i * i));
  angles[40] += 0.5;
  return angles;
}

std::shared_ptr<const Track> with_positions(const std::vector<double>& angles) {
  Track track = turns_of(angles);
  KeyframeData data;
  for (std::size_t i = 0; i < track.keys.size(); ++i) {
    data.times.push_back(track.keys.times()[i]);
    data.orientations.push_back(track.keys.orientations()[i]);
    data.positions.emplace_back(angles[i], 0.0, 0.0);
  }
  track.keys = *Keyframes::make(std::move(data));
  return std::make_shared<const Track>(std::move(track));
}

ReduceRequest request_of(std::vector<std::shared_ptr<const Track>> recordings) {
  return {.recordings = std::move(recordings), .options = {.tolerance = {.angle = tolerance}}};
}

ReduceOutcome reduced(const ReduceRequest& request) { return reduce(request).front().value(); }

TEST(ReduceJob, TakesTheFewestKeysOfTheUsualMethods) {
  const ReduceOutcome outcome = reduced(request_of({turns({0.0, 0.5, 1.0, 1.5})}));
  ASSERT_EQ(outcome.reductions.size(), reducing_methods.size());
  for (const Reduction& reduction : outcome.reductions)
    EXPECT_LE(outcome.chosen().samples.size(), reduction.samples.size()) << reduction.method.name;
  EXPECT_EQ(&outcome.reduced(), outcome.recording.get());
  EXPECT_TRUE(outcome.warnings.empty());
}

TEST(ReduceJob, TellsMethodsOfOneNameFromEachOther) {
  Method loose("quintic");
  loose.options.parameters["tension"] = {0.25};
  ReduceRequest request = request_of({turns({0.0, 0.5, 1.0, 1.5})});
  request.methods = {"quintic", loose};
  const ReduceOutcome outcome = reduced(request);
  const Json document = document_of(outcome);
  const Json methods = member(document, "methods");
  const auto& rows = std::get<Json::Array>(methods.value());
  EXPECT_EQ(std::get<std::string>(member(rows[1], "method").value()), "quintic:tension=0.25");
  EXPECT_EQ(std::get<std::string>(member(rows[0], "method").value()), "quintic");
  for (const char* const row :
       {"\n  method                   keys ", "\n  quintic                 ", "\n  quintic:tension=0.25    "})
    EXPECT_NE(summary_of(outcome).find(row), std::string::npos) << row << summary_of(outcome);
}

TEST(ReduceJob, HoldsWhatItsSmoothingWasAskedFor) {
  ReduceRequest request = request_of({turns(noisy_angles())});
  request.smoothing = SmoothOptions{.loss = Loss::tukey};
  const ReduceOutcome outcome = reduced(request);
  ASSERT_TRUE(outcome.smoothed);
  EXPECT_EQ(
      std::get<std::string>(member(document_of(static_cast<const SmoothOutcome&>(*outcome.smoothed)), "loss").value()),
      "tukey");
}

TEST(ReduceJob, SmoothsFirstAndSaysHowFarTheRecordingIs) {
  ReduceRequest request = request_of({turns(noisy_angles())});
  request.smoothing = SmoothOptions{};
  const ReduceOutcome outcome = reduced(request);
  ASSERT_TRUE(outcome.smoothed);
  EXPECT_EQ(outcome.smoothed->smoothing.rejected, std::vector<std::size_t>{40});
  EXPECT_LT(outcome.smoothed->raw.largest, 0.1) << "what was rejected does not count";
  EXPECT_GT(outcome.smoothed->raw.largest, outcome.chosen().deviation.angle);
  EXPECT_FALSE(outcome.smoothed->raw_positions);
  EXPECT_EQ(&outcome.reduced(), &outcome.smoothed->smoothing.track);
  const std::string summary = summary_of(outcome);
  EXPECT_NE(summary.find("\n  rejected        1: key 40 (40 s)\n"), std::string::npos) << summary;
  EXPECT_NE(line_of(outcome).find("; smoothed with "), std::string::npos) << line_of(outcome);
}

TEST(ReduceJob, MeasuresThePathOfTheRecordingToo) {
  ReduceRequest request = request_of({with_positions(noisy_angles())});
  request.options.tolerance.position = 0.05;
  request.smoothing = SmoothOptions{};
  const ReduceOutcome outcome = reduced(request);
  ASSERT_TRUE(outcome.smoothed && outcome.smoothed->raw_positions);
  const Json smoothing = member(document_of(outcome), "smoothing");
  EXPECT_EQ(number(smoothing, "raw_position_error_max_m"), outcome.smoothed->raw_positions->largest);
  EXPECT_NE(summary_of(outcome).find("\n  raw positions   "), std::string::npos) << summary_of(outcome);
}

TEST(ReduceJob, WarnsOfPositionsThatAreNotChecked) {
  ReduceRequest request = request_of({with_positions({0.0, 0.5, 1.0})});
  ASSERT_EQ(reduced(request).warnings.size(), 1u);
  EXPECT_EQ(reduced(request).warnings.front().code, "positions_unchecked");
  request.options.tolerance.position = 0.1;
  EXPECT_TRUE(reduced(request).warnings.empty());
}

TEST(ReduceJob, SaysTheSameInItsDocumentAndItsSummary) {
  ReduceOutcome outcome = reduced(request_of({turns({0.0, 0.5, 1.0, 1.5})}));
  const Json document = document_of(outcome);
  EXPECT_DOUBLE_EQ(number(document, "tolerance_deg"), tolerance * degrees);
  EXPECT_EQ(std::get<std::string>(member(document, "method").value()), outcome.chosen().method.name);
  EXPECT_EQ(std::get<Json::Array>(member(document, "methods").value()).size(), outcome.reductions.size());
  const std::string first = "4 samples from data/arm.csv, tolerance 1.14592°\n";
  EXPECT_TRUE(summary_of(outcome).starts_with(first + "  method")) << summary_of(outcome);
  EXPECT_TRUE(line_of(outcome).starts_with("2 keys of auto from 4 samples, ")) << line_of(outcome);
  outcome.mended = "dropped 1 row";
  EXPECT_TRUE(summary_of(outcome).starts_with(first + "dropped 1 row\n")) << summary_of(outcome);
  EXPECT_TRUE(line_of(outcome).ends_with("; dropped 1 row")) << line_of(outcome);
}

TEST(ReduceJob, PutsErrorsInTheirPlace) {
  ReduceRequest request = request_of({turns({0.0, 0.5, 1.0}), turns({0.0})});
  const auto outcomes = reduce(request);
  EXPECT_TRUE(outcomes[0]);
  ASSERT_FALSE(outcomes[1]);
  EXPECT_EQ(describe(outcomes[1].error()), "data/arm.csv: curve 1: found 1 sample, wanted 2 or more");
  request.recordings.erase(request.recordings.begin());
  EXPECT_EQ(describe(reduce(request).front().error()), "data/arm.csv: found 1 sample, wanted 2 or more");
  request.options.tolerance.position = 0.1;
  const Error error = reduce(request).front().error();
  EXPECT_EQ(error.option, "position_tolerance");
  EXPECT_EQ(error.where.file, "data/arm.csv");
}

TEST(ReduceJob, BlamesTheUserAloneForHisMethod) {
  ReduceRequest request = request_of({turns({0.0, 0.5, 1.0})});
  request.methods = {Method("bspline")};
  const Error error = reduce(request).front().error();
  EXPECT_EQ(error.code, ErrorCode::bad_argument);
  EXPECT_TRUE(error.where.file.empty());
}

TEST(ReduceJob, StopsWhereItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  ReduceRequest request = request_of({turns(noisy_angles())});
  EXPECT_EQ(reduce(request, {.stop = source.get_token()}).front().error().code, ErrorCode::cancelled);
  request.smoothing = SmoothOptions{};
  EXPECT_EQ(reduce(request, {.stop = source.get_token()}).front().error().code, ErrorCode::cancelled);
}

}}  // namespace orispline::jobs
