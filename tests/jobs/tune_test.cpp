// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/tune.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

TuneRequest request_for(std::shared_ptr<const Track> keys) {
  auto chosen = chosen_method(std::nullopt, *keys, usual_tuned);
  return {.keys = std::move(keys), .method = std::move(*chosen)};
}

TEST(TuneJob, TakesTheMethodOfTheKeysWhereItHasTensions) {
  const std::vector<double> angles{0.0, 1.0, 1.5, 0.5, 0.0};
  EXPECT_EQ(tune(request_for(turns(angles, "quintic")))->tuning.method.name, "quintic");
  EXPECT_EQ(tune(request_for(turns(angles, "slerp")))->tuning.method.name, "timed-c2");
  EXPECT_EQ(tune(request_for(turns(angles)))->tuning.method.name, "timed-c2");
}

TEST(TuneJob, CountsTheTimesOfARecordingAsThoseOfTheKeys) {
  const auto energy_beside = [](std::vector<double> times, double epoch) {
    TuneRequest request = request_for(turns({0.0, 1.0, 1.5, 0.5, 0.0}));
    Track recording = *turns_of({0.9, 1.6, 0.6}).with_times(std::move(times));
    recording.epoch = Decimal::from_double(epoch);
    request.reference = std::make_shared<const Track>(std::move(recording));
    request.options.objective = Objective::fit;
    return tune(std::move(request))->tuning.energy_after;
  };
  EXPECT_EQ(energy_beside({0.25, 1.25, 2.25}, 1.25), energy_beside({1.5, 2.5, 3.5}, 0.0));
}

TEST(TuneJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome = tune(request_for(turns({0.0, 1.0, 1.5, 0.5, 0.0})));
  ASSERT_TRUE(outcome);
  const Json document = document_of(*outcome);
  EXPECT_EQ(number(document, "energy_after"), outcome->tuning.energy_after);
  const auto& tensions = outcome->values(outcome->tuning.parameters.front());
  const Json told = member(document, outcome->tuning.parameters.front());
  EXPECT_EQ(std::get<Json::Array>(told.value()).size(), tensions.size());
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(summary.starts_with("5 keys from data/arm.csv, timed-c2\nacceleration: ")) << summary;
}

TEST(TuneJob, KnowsWhichMethodsHaveTensions) {
  EXPECT_TRUE(has_tensions(**find_family("tcb")));
  EXPECT_FALSE(has_tensions(**find_family("auto")));
}

}}  // namespace orispline::jobs
