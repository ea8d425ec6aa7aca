// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/retime.hpp>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

RetimeOutcome retimed(std::shared_ptr<const Track> keys, const std::optional<Method>& named = std::nullopt) {
  auto chosen = chosen_method(named, *keys, usual_retimed);
  return retime({.keys = std::move(keys), .method = std::move(*chosen), .options = {.limits = {.rate = Limit(0.5)}}})
      .value();
}

TEST(RetimeJob, KeepsTheMethodThatTheKeysAreFor) {
  EXPECT_EQ(retimed(turns({0.0, 1.0, 1.5}, "timed-c2:ends=rest")).retiming.method.name, "timed-c2");
}

TEST(RetimeJob, HoldsRestsOnlyWhereNobodyNamesAMethod) {
  const std::vector<double> stop{0.0, 1.0, 1.0, 2.0};
  const auto holds = [](const RetimeOutcome& outcome) {
    return outcome.retiming.method.options.parameters.contains("hold");
  };
  EXPECT_TRUE(holds(retimed(turns(stop))));
  EXPECT_FALSE(holds(retimed(turns(stop), Method("auto"))));
  EXPECT_FALSE(holds(retimed(turns(stop, "auto"))));
  EXPECT_FALSE(holds(retimed(turns(stop, "hermite-c1")))) << "which is set aside, but was meant";
}

TEST(RetimeJob, WarnsOfTheMethodAndOfTheRetiming) {
  const RetimeOutcome outcome = retimed(turns({0.0, 1.0, 1.0, 2.0}, "auto"), Method("timed-c2"));
  ASSERT_GE(outcome.warnings.size(), 2u);
  EXPECT_EQ(outcome.warnings[0].code, "recipe_set_aside");
  EXPECT_EQ(outcome.warnings[1].code, "moving_rests");
}

TEST(RetimeJob, SaysTheSameInItsDocumentAndItsSummary) {
  const RetimeOutcome outcome = retimed(turns({0.0, 1.0, 1.5}), Method("slerp"));
  const Json document = document_of(outcome);
  EXPECT_EQ(number(document, "duration_before_s"), 2.0);
  EXPECT_NEAR(number(document, "duration_after_s"), 4.0, 1e-3);
  EXPECT_LE(number(document, "rate_bound_deg_s"), 0.5 * degrees);
  const std::string summary = summary_of(outcome);
  EXPECT_TRUE(summary.starts_with("3 keys from data/arm.csv, slerp: 2 s before, ")) << summary;
  EXPECT_NE(summary.find("\nrate: nowhere above "), std::string::npos) << summary;
  EXPECT_TRUE(line_of(outcome).starts_with("3 keys for slerp, 2 s before, ")) << line_of(outcome);
}

TEST(RetimeJob, PutsErrorsInTheirPlace) {
  const auto one = turns({0.0});
  const auto outcome =
      retime({.keys = one, .method = {Method("slerp"), {}, {}}, .options = {.limits = {.rate = Limit(0.5)}}});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().where.file, "data/arm.csv");
}

TEST(RetimeJob, StopsWhereItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  const auto outcome = retime({.keys = turns({0.0, 1.0, 1.5}),
                               .method = {Method("slerp"), {}, {}},
                               .options = {.limits = {.rate = Limit(0.5)}}},
                              {.stop = source.get_token()});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::cancelled);
}

}}  // namespace orispline::jobs
