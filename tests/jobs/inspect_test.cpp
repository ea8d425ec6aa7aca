// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/inspect.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

std::vector<double> wide_swing(std::size_t samples) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < samples; ++i) angles.push_back(std::sin(0.3 * static_cast<double>(i)));
  return angles;
}

TEST(InspectJob, SaysHowContinuousEachMethodIsOnTheKeys) {
  const auto outcome = inspect({.keys = turns(wide_swing(9)), .methods = {Method("slerp"), Method("timed-c2")}});
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->methods.size(), 2u);
  EXPECT_EQ(outcome->methods[0].continuity.order(), 0);
  EXPECT_EQ(outcome->methods[1].continuity.order(), 2);
  const Json document = document_of(*outcome);
  const Json methods = member(document, "methods");
  EXPECT_EQ(std::get<std::int64_t>(member(std::get<Json::Array>(methods.value())[1], "continuity_order").value()), 2);
  EXPECT_NE(summary_of(*outcome).find("\ntimed-c2               C2  "), std::string::npos) << summary_of(*outcome);
}

TEST(InspectJob, TellsMethodsOfOneNameFromEachOther) {
  Method first("quintic"), second("quintic");
  first.options.parameters["tension"] = {0.3, 0.7, -0.2, 0.9, 0.4};
  second.options.parameters["tension"] = {0.5};
  const auto outcome = inspect({.keys = turns(wide_swing(5)), .methods = {first, second}});
  ASSERT_TRUE(outcome);
  const Json methods = member(document_of(*outcome), "methods");
  const auto& rows = std::get<Json::Array>(methods.value());
  EXPECT_EQ(std::get<std::string>(member(rows[0], "method").value()), "quintic:tension=0.3,0.7,-0.2,0.9,0.4");
  EXPECT_EQ(std::get<std::string>(member(rows[1], "method").value()), "quintic:tension=0.5");
  const std::string summary = summary_of(*outcome);
  for (const char* const row : {"\nquintic:tension=0.3,0.7,-0.2,0.9,0.4\n                       C2  ",
                                "\nquintic:tension=0.5    C2  ", "\nquintic:tension=0.5    G3  "})
    EXPECT_NE(summary.find(row), std::string::npos) << row << summary;
}

TEST(InspectJob, CountsKeysOfAWrongNormAmongThoseThatAreNotUnit) {
  const auto outcome = inspect(
      {.keys = turns(wide_swing(5)), .faults = {.wrong_norms = 2, .largest_norm_error = 0.5, .defect = "key 2: no"}});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->keyframes.non_unit_keys, 2u);
  EXPECT_EQ(outcome->keyframes.largest_norm_error, 0.5);
  EXPECT_NE(summary_of(*outcome).find("\ndefect        key 2: no\n"), std::string::npos);
  EXPECT_EQ(std::get<std::string>(member(document_of(*outcome), "defect").value()), "key 2: no");
}

TEST(InspectJob, SaysWhereACurveJumpsBetweenItsKeys) {
  auto outcome = inspect({.keys = turns(wide_swing(5)), .methods = {Method("timed-c2")}}).value();
  EXPECT_EQ(summary_of(outcome).find(" jumps by "), std::string::npos);
  outcome.methods[0].continuity.orientation = {.angle = 0.5, .time = 2.25, .key = 2};
  EXPECT_NE(summary_of(outcome).find("\ntimed-c2              C-1  "), std::string::npos) << summary_of(outcome);
  EXPECT_NE(
      summary_of(outcome).find("\ntimed-c2 jumps by 28.65° between two keys, after key 2 (2 s); put a key in between, "
                               "or take timed-c2\n"),
      std::string::npos)
      << summary_of(outcome);
  const Json method = std::get<Json::Array>(member(document_of(outcome), "methods").value())[0];
  EXPECT_EQ(std::get<std::int64_t>(member(method, "continuity_order").value()), -1);
  EXPECT_EQ(std::get<std::uint64_t>(member(method, "orientation_jump_max_after_key").value()), 2u);
  EXPECT_NEAR(number(method, "orientation_jump_max_deg"), 28.647889756541161, 1e-12);
}

TEST(InspectJob, TellsWhatTheKeysSayToTheMethodMeasured) {
  const auto outcome = inspect({.keys = turns(wide_swing(40)), .methods = {Method("measured"), Method("auto")}});
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->methods[0].findings);
  EXPECT_FALSE(outcome->methods[1].findings);
  EXPECT_NE(summary_of(*outcome).find("\nThe keys say to measured: "), std::string::npos);
}

TEST(InspectJob, SaysWhereTheKeysAre) {
  Track track = turns_of({0.0, 0.1, 0.9});
  track.lines = {2, 3, 5};
  track.recipe = {.method = "auto", .line = 1};
  const auto outcome = inspect({.keys = std::make_shared<const Track>(std::move(track))});
  ASSERT_TRUE(outcome);
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(summary.starts_with("data/arm.csv\nkeys          3, 0 to 2 s, span 2 s\n")) << summary;
  EXPECT_NE(summary.find("after key 1 (line 3, 1 s)"), std::string::npos) << summary;
  EXPECT_NE(summary.find("keys for      auto, as line 1 says\n"), std::string::npos) << summary;
}

}}  // namespace orispline::jobs
