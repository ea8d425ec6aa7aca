// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/plot.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

TEST(PlotJob, DrawsEveryMethodUnderATitle) {
  const auto outcome = plot({.name = "arm.csv", .keys = turns({0.0, 1.0, 2.5}), .methods = {"auto", "slerp"}});
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_NE(outcome->svg.find("arm.csv: 3 keys<"), std::string::npos);
  for (const char* const name : {">auto<", ">slerp<"}) EXPECT_NE(outcome->svg.find(name), std::string::npos) << name;
  EXPECT_TRUE(outcome->warnings.empty());
}

TEST(PlotJob, TellsMethodsOfOneNameFromEachOther) {
  Method vector("quintic");
  vector.options.parameters["tension"] = {0.3, 0.7, 0.2};
  const auto outcome = plot({.name = "arm.csv", .keys = turns({0.0, 1.0, 2.5}), .methods = {"quintic", vector}});
  ASSERT_TRUE(outcome) << describe(outcome.error());
  for (const char* const name : {">quintic<", ">quintic:tension=0.3,0.7,0.2<"})
    EXPECT_NE(outcome->svg.find(name), std::string::npos) << name;
}

TEST(PlotJob, TellsWhatIsNoteworthyAboutTheKeys) {
  const auto outcome = plot({.name = "arm.csv", .keys = turns({0.0, std::numbers::pi}), .methods = {"slerp"}});
  ASSERT_TRUE(outcome) << describe(outcome.error());
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings[0].code, "near_half_turn");
}

TEST(PlotJob, PutsErrorsInTheirPlace) {
  Method bare("tcb");
  bare.options.parameters["tension"] = {0.0, 0.5};
  const auto outcome = plot({.name = "arm.csv", .keys = turns({0.0, 1.0, 2.0}), .methods = {bare}});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::bad_argument);
}

}}  // namespace orispline::jobs
