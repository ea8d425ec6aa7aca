// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample.hpp>

#include <gtest/gtest.h>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

SampleOutcome outcome_for(const Track& keys, const Method& method) {
  return outcome_of(keys, method, curve_of_keys(method, keys).value());
}

TEST(SampleJob, SaysWhatIsSampled) {
  Track keys = turns_of({0.0, 0.5, 0.7});
  keys.epoch = Decimal::from_double(100.0);
  SampleOutcome outcome = outcome_for(keys, "auto");
  outcome.samples = 201;
  EXPECT_EQ(summary_of(outcome), "3 keys from data/arm.csv, 100 to 102 s\n201 samples with auto\n");
  outcome.mended = "sorted 2 rows";
  outcome.written_to = "out.csv";
  outcome.held_samples = 3;
  EXPECT_EQ(summary_of(outcome),
            "3 keys from data/arm.csv, 100 to 102 s\nsorted 2 rows\n201 samples with auto written to out.csv\n"
            "3 samples outside the curve hold the end orientation\n");
  EXPECT_TRUE(line_of(outcome).starts_with("201 samples with auto from 3 keys; sorted 2 rows; 3 samples outside"))
      << line_of(outcome);
}

TEST(SampleJob, PutsTheMembersOfAFaceInTheirPlaces) {
  const Json document =
      document_of(outcome_for(turns_of({0.0, 0.5}), "slerp"), {{"frame", "body"}}, {{"rows_moved", 0}});
  std::vector<std::string> names;
  for (const auto& [name, value] : std::get<Json::Object>(document.value())) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"method", "method_text", "keys", "start_s", "end_s", "samples",
                                             "held_samples", "gap_samples", "frame", "sign_flips", "non_unit_keys",
                                             "rows_moved", "findings", "band", "truth"}));
}

TEST(SampleJob, MeasuresTheTruthInTheTimesOfTheKeys) {
  const Track keys = turns_of({0.0, 1.0, 2.0});
  Track truth = turns_of({0.5, 1.6});
  truth.epoch = Decimal::from_double(0.5);
  truth.name = "truth.csv";
  const PoseCurve curve = shaped_curve("slerp", keys).value();
  const TruthDistance found = distance_to_truth(curve, keys, truth);
  EXPECT_EQ(found.recording, "truth.csv");
  EXPECT_EQ(found.distance.count, 2u);
  EXPECT_NEAR(found.distance.largest, 0.1, 1e-12);
  EXPECT_EQ(found.largest_time.to_string(), "1.5");
}

TEST(CurveOfKeys, BlamesTheRecipeForWhatOnlyItSays) {
  Track keys = turns_of({0.0, 0.5, 0.7});
  keys.recipe = {.method = "quintic:tension=0.1,0.2", .line = 4};
  const Method stated("quintic", {.parameters = {{"tension", {0.1, 0.2}}}});
  const auto of_file = shaped_curve(stated, keys);
  ASSERT_FALSE(of_file);
  EXPECT_EQ(of_file.error().code, ErrorCode::bad_data);
  EXPECT_EQ(of_file.error().where.line, 4u);
  EXPECT_EQ(of_file.error().remedy, "recipe");
  keys.recipe = {};
  const auto of_user = shaped_curve(stated, keys);
  ASSERT_FALSE(of_user);
  EXPECT_EQ(of_user.error().code, ErrorCode::bad_argument);
}

TEST(CurveOfKeys, BlamesTheColumnsForTheirSettings) {
  Track keys = turns_of({0.0, 0.5, 0.7});
  keys.settings = {{"tension", {0.5, 1e9, 0.5}}};
  const auto curve = shaped_curve("quintic", keys);
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.error().code, ErrorCode::bad_data);
  EXPECT_EQ(curve.error().where.file, "data/arm.csv");
}

}}  // namespace orispline::jobs
