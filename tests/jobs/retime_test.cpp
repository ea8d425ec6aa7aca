// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/retime.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <orispline/families/method_text.hpp>

namespace orispline::jobs { namespace {

/// About z by these angles [rad], one second apart.
std::shared_ptr<const Track> turns(const std::vector<double>& angles, std::string recipe = "") {
  KeyframeData data;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    data.times.push_back(static_cast<double>(i));
    data.orientations.emplace_back(Eigen::AngleAxisd(angles[i], Eigen::Vector3d::UnitZ()));
  }
  Track track(*Keyframes::make(std::move(data)));
  track.name = "arm.csv";
  track.recipe.method = std::move(recipe);
  return std::make_shared<const Track>(std::move(track));
}

RetimeOutcome retimed(std::shared_ptr<const Track> keys, const std::optional<Method>& named = std::nullopt) {
  auto chosen = chosen_method(named, *keys, usual_retimed);
  return retime({.keys = std::move(keys), .method = std::move(*chosen), .options = {.limits = {.rate = Limit(0.5)}}})
      .value();
}

const Json* member(const Json& json, std::string_view name) {
  for (const auto& [key, value] : std::get<Json::Object>(json.value()))
    if (key == name) return &value;
  return nullptr;
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
  EXPECT_EQ(std::get<double>(member(document, "duration_before_s")->value()), 2.0);
  EXPECT_NEAR(std::get<double>(member(document, "duration_after_s")->value()), 4.0, 1e-3);
  EXPECT_NE(member(document, "rate_bound_deg_s"), nullptr);
  const std::string summary = summary_of(outcome);
  EXPECT_TRUE(summary.starts_with("3 keys from arm.csv, slerp: 2 s before, ")) << summary;
  EXPECT_NE(summary.find("\nrate: nowhere above "), std::string::npos) << summary;
  EXPECT_TRUE(line_of(outcome).starts_with("3 keys for slerp, 2 s before, ")) << line_of(outcome);
}

TEST(RetimeJob, PutsErrorsInTheirPlace) {
  const auto one = turns({0.0});
  const auto outcome =
      retime({.keys = one, .method = {Method("slerp"), {}, {}}, .options = {.limits = {.rate = Limit(0.5)}}});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().where.file, "arm.csv");
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

}  // namespace
}  // namespace orispline::jobs
