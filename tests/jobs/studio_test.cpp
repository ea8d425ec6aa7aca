// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/studio.hpp>

#include <array>

#include <gtest/gtest.h>

#include <orispline/base/version.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

using namespace std::string_view_literals;

constexpr std::array page{
    "<script>const marker = '__ORISPLINE_STUDIO_DATA__'</script><script type=json>__ORISPLINE_ST"sv,
    "UDIO_DATA__</script>"sv};

StudioRequest request_of(std::shared_ptr<const Track> keys) {
  return {.name = "a</script>\"\n.csv",
          .bytes = "t,qw</script>\xff",
          .keys = std::move(keys),
          .method = {.method = Method(default_method), .by = NamedBy::nobody}};
}

std::shared_ptr<const Track> many(std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(static_cast<double>(k));
  return turns(times);
}

TEST(StudioJob, PutsTheFileAndTheMethodsIntoThePlaceOfTheMarker) {
  StudioRequest request = request_of(turns({0.0, 1.0, 1.5}));
  request.method = {.method = Method("timed-c2"), .by = NamedBy::user};
  request.method.method.options.parameters["tension"] = {0.6};
  request.beside = Method("squad");
  const auto outcome = studio(request);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  const std::string data = R"({"studio":1,"version":")" + std::string(version) +
                           R"(","name":"a\u003c/script>\u0022\u000a.csv","content":"dCxxdzwvc2NyaXB0Pv8=",)" +
                           R"("method":"timed-c2:tension=0.6","beside":"squad"})";
  EXPECT_EQ(outcome->data, data);
  EXPECT_EQ(studio_page(page, data),
            "<script>const marker = '__ORISPLINE_STUDIO_DATA__'</script><script type=json>" + data + "</script>");
}

TEST(StudioJob, LeavesMethodsThatNobodyNamedToThePage) {
  const auto outcome = studio(request_of(turns({0.0, 1.0, 1.5})));
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_TRUE(outcome->data.ends_with(R"("method":null,"beside":null})")) << outcome->data;
}

TEST(StudioJob, LeavesTheMarkerWhereThereAreNoKeys) {
  EXPECT_EQ(studio_page(page, ""), std::string(page.front()) + std::string(page.back()));
}

TEST(StudioJob, RefusesAMethodThatDoesNotSuitTheKeys) {
  StudioRequest request = request_of(turns({0.0, 1.0}));
  request.beside = Method("timed-c2");
  request.beside->options.start = {.rule = EndRule::quadratic};
  const auto outcome = studio(request);
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.error().message.find("need 3 keys, found 2"), std::string::npos) << describe(outcome.error());
}

TEST(StudioJob, WarnsOfMoreKeysThanThePageEdits) {
  EXPECT_TRUE(studio(request_of(many(1000)))->warnings.empty());
  const auto outcome = studio(request_of(many(1001)));
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings.front().code, "many_keys");
}

}}  // namespace orispline::jobs
