// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/compare.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/report/table.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

std::vector<double> swing(std::size_t samples) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < samples; ++i) angles.push_back(std::sin(0.1 * static_cast<double>(i)));
  return angles;
}

CompareRequest request_for(const std::vector<std::string>& methods) {
  CompareRequest request{.keys = turns(swing(61)), .decimations = {{.keep_every = 10}}, .threads = 1};
  for (const std::string& name : methods) request.methods.push_back({name, name});
  return request;
}

std::vector<std::string> labels_of(const CompareOutcome& outcome) {
  std::vector<std::string> labels;
  for (const ComparedMethod& method : outcome.methods) labels.push_back(method.label);
  return labels;
}

TEST(CompareJob, PutsTheBestFirstOnEachSetOfKeys) {
  CompareRequest request = request_for({"slerp", "auto"});
  request.decimations.push_back({.keep_every = 20});
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  EXPECT_EQ(labels_of(*outcome), (std::vector<std::string>{"auto", "slerp", "auto", "slerp"}));
  EXPECT_EQ(outcome->methods[1].key_set, 0u);
  EXPECT_EQ(outcome->methods[2].key_set, 1u);
}

TEST(CompareJob, TunesEachMethodWithTensionsOnceMore) {
  CompareRequest request = request_for({"slerp", "timed-c2", "auto"});
  request.tune = true;
  request.sort = "energy";
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  auto labels = labels_of(*outcome);
  EXPECT_LT(std::ranges::find(labels, "timed-c2:tuned"), std::ranges::find(labels, "timed-c2"));
  std::ranges::sort(labels);
  EXPECT_EQ(labels, (std::vector<std::string>{"auto", "slerp", "timed-c2", "timed-c2:tuned"}));
}

TEST(CompareJob, KeepsWhatFailsWithTheReason) {
  CompareRequest request = request_for({"bezier", "slerp"});
  request.decimations = {{.keep_every = 12}};  // 6 keys, where bezier wants a whole number of segments of three
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->methods.back().label, "bezier");
  ASSERT_FALSE(outcome->methods.back().measures);
  EXPECT_EQ(outcome->methods.back().measures.error().where.file, "data/arm.csv");
}

TEST(CompareJob, WantsAValueForEachKeyThatIsKept) {
  CompareRequest request = request_for({"slerp"});
  Method vector("quintic");
  vector.options.parameters["tension"] = {0.3, 0.7, 0.2, 0.9, 0.4, 0.5, 0.6};
  request.methods.push_back({"quintic:…", vector});
  const auto outcome = compare(request);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_TRUE(outcome->methods[0].measures && outcome->methods[1].measures);
  request.decimations.push_back({.keep_every = 20});
  const Error error = compare(request).error();
  EXPECT_EQ(error.code, ErrorCode::bad_argument);
  EXPECT_EQ(
      error.message,
      "quintic: found 7 values of tension, wanted 1 or one per key (4); `keep_every` 20 keeps 4 of the 61 samples");
  request.reference = request.keys;
  EXPECT_EQ(compare(request).error().message, "quintic: found 7 values of tension, wanted 1 or one per key (61)");
}

TEST(CompareJob, PutsALongLabelAboveItsNumbers) {
  CompareRequest request = request_for({"slerp"});
  request.methods.push_back({"slerp, with a name that is longer than any", "slerp"});
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  EXPECT_NE(summary_of(*outcome).find("\n  slerp, with a name that is longer than any\n          C0  "),
            std::string::npos)
      << summary_of(*outcome);
}

TEST(CompareJob, RefusesAMeasureThatThereIsNot) {
  CompareRequest request = request_for({"slerp"});
  for (const auto& [sort, message] : {std::pair{"torque", "found 'torque', wanted `inertia` as well"},
                                      std::pair{"rate",
                                                "found 'rate', wanted angular velocities as columns wx,wy,wz "
                                                "in data/arm.csv"}}) {
    request.sort = sort;
    const auto outcome = compare(request);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().option, "sort");
    EXPECT_EQ(outcome.error().message, message);
  }
  request.sort = "torque";
  request.has_inertia = true;
  EXPECT_TRUE(compare(request));
}

TEST(CompareJob, SaysTheSameInAllItsTables) {
  CompareRequest request = request_for({"slerp", "auto"});
  request.decimations.push_back({.keep_every = 20});
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  const Json document = document_of(*outcome);
  const auto& rows = std::get<Json::Array>(document.value());
  const std::string csv = csv_of(*outcome);
  EXPECT_EQ(std::ranges::count(csv, '\n'), static_cast<std::ptrdiff_t>(1 + rows.size()));
  EXPECT_EQ(number(rows[1], "rms_deg"), *outcome->value(outcome->measures().front(), outcome->methods[1]));
  const auto tables = tables_of(*outcome);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[1].title, "arm.csv: every 20th sample kept, 4 keys, 61 samples compared");
  EXPECT_EQ(tables[1].rows.size(), 2u);
  EXPECT_EQ(summary_of(*outcome), text_of(tables[0]) + "\n" + text_of(tables[1]));
  EXPECT_TRUE(line_of(*outcome).starts_with("best by rms: auto at every 10th")) << line_of(*outcome);
}

TEST(CompareJob, WarnsOfARecordingThatIsNotDenser) {
  CompareRequest request = request_for({"slerp"});
  request.reference = request.keys;
  const auto outcome = compare(std::move(request));
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings.front().code, "no_reference_between_keys");
}

TEST(CompareJob, StopsWhereItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  const auto outcome = compare(request_for({"slerp"}), {.stop = source.get_token()});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::cancelled);
}

}}  // namespace orispline::jobs
