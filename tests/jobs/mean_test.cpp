// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/mean.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(MeanJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome = mean({.rows = turns({0.0, 2 * degree, 4 * degree})});
  ASSERT_TRUE(outcome);
  const Json document = document_of(*outcome);
  EXPECT_NEAR(number(document, "qz"), std::sin(degree), 1e-15);
  EXPECT_EQ(count(document, "rows"), 3u);
  EXPECT_NEAR(number(document, "largest_distance_rad"), 2 * degree, 1e-15);
  EXPECT_EQ(member(document, "position_sigma_m").value().index(), Json(nullptr).value().index());
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(summary.starts_with("3 rows from data/arm.csv\norientation mean\n")) << summary;
  EXPECT_NE(summary.find("1.633° RMS, 2° at most (row "), std::string::npos) << summary;
  EXPECT_EQ(line_of(*outcome), "mean of 3 rows, 1.633° RMS, 2° at most");
}

TEST(MeanJob, WeighsByTheSettingOfThatName) {
  Track rows = turns_of({0.0, 4 * degree});
  rows.settings["weight"] = {3.0, 1.0};
  const auto outcome = mean({.rows = std::make_shared<const Track>(std::move(rows))});
  ASSERT_TRUE(outcome);
  EXPECT_NEAR(number(document_of(*outcome), "qz"), std::sin(0.5 * degree), 1e-15);
  EXPECT_EQ(number(document_of(*outcome), "weight"), 4.0);
  EXPECT_TRUE(summary_of(*outcome).starts_with("2 rows from data/arm.csv, weighted\n"));
}

TEST(MeanJob, HasAMeanForEachWindowWithRows) {
  Track rows = *turns_of({0.0, 2 * degree, 10 * degree, 14 * degree}).with_times({0.0, 0.9, 2.0, 2.5});
  rows.epoch = Decimal::from_double(100.0);
  const auto outcome = mean({.rows = std::make_shared<const Track>(std::move(rows)), .options = {.every = 1.0}});
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->windows.size(), 2u);
  EXPECT_EQ(outcome->windows[1].time, 2.5);
  EXPECT_EQ(outcome->windows[1].first, 2u);
  EXPECT_GE(outcome->windows[1].mean.farthest, 2u);
  const Track means = outcome->track();
  EXPECT_EQ(means.time_of(1), Decimal::from_double(102.5));
  EXPECT_NEAR(means.keys.orientations()[1].z(), std::sin(6 * degree), 1e-15);
  EXPECT_EQ(std::get<Json::Array>(member(document_of(*outcome), "windows").value()).size(), 2u);
  EXPECT_NE(summary_of(*outcome).find("2 windows of 1 s\n"), std::string::npos);
}

TEST(MeanJob, TakesTheRowsOfSeveralFilesAsOneSet) {
  Track first = turns_of({0.0, 1 * degree}), second = turns_of({5 * degree});
  first.name = "a.csv";
  second.name = "b.csv";
  first.lines = {2, 3};
  second.lines = {7};
  const auto request = mean_of_all(std::vector<Track>{first, second}, {});
  ASSERT_TRUE(request) << describe(request.error());
  const auto outcome = mean(*request);
  ASSERT_TRUE(outcome);
  EXPECT_NEAR(number(document_of(*outcome), "qz"), std::sin(1 * degree), 1e-15);
  EXPECT_TRUE(summary_of(*outcome).starts_with("3 rows from 2 files\n"));
  EXPECT_NE(summary_of(*outcome).find("(line 7 of b.csv)"), std::string::npos);
  const Json farthest = member(document_of(*outcome), "farthest");
  EXPECT_EQ(std::get<std::string>(member(farthest, "file").value()), "b.csv");
  EXPECT_EQ(count(farthest, "key"), 0u);
}

TEST(MeanJob, RefusesFilesThatAreNotAlike) {
  Track plain = turns_of({0.0}), weighted = turns_of({5 * degree});
  plain.name = "a.csv";
  weighted.name = "b.csv";
  weighted.settings["weight"] = {1.0};
  for (const auto& files : {std::vector<Track>{plain, weighted}, std::vector<Track>{weighted, plain}}) {
    const auto request = mean_of_all(files, {});
    ASSERT_FALSE(request);
    EXPECT_EQ(describe(request.error()), "a.csv: found no weights, which b.csv has, wanted them in all or in none");
  }
  EXPECT_EQ(mean_of_all(std::vector<Track>{plain, plain}, {.every = 1.0}).error().option, "every");
}

TEST(MeanJob, GathersTheWarningsOfWindows) {
  Track rows = *turns_of({0.0, 2 * degree, 10 * degree, 14 * degree}).with_times({0.0, 0.9, 2.0, 2.5});
  const auto shared = std::make_shared<const Track>(std::move(rows));
  const auto outcome = mean({.rows = shared, .options = {.kind = MeanKind::median, .every = 1.0}});
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings[0].code, "median_of_a_range");
  EXPECT_TRUE(outcome->warnings[0].message.starts_with("in 2 of 2 windows, first here: "))
      << outcome->warnings[0].message;
}

TEST(MeanJob, NamesTheRowsOfAWindowThatHasNoMean) {
  Track rows = *turns_of({0.0, 0.1, 0.2, 0.2 + std::numbers::pi}).with_times({0.0, 0.5, 1.0, 1.5});
  rows.lines = {2, 3, 4, 5};
  const auto outcome = mean({.rows = std::make_shared<const Track>(std::move(rows)), .options = {.every = 1.0}});
  ASSERT_FALSE(outcome);
  EXPECT_TRUE(describe(outcome.error()).starts_with("data/arm.csv:4: key 2: found orientations that cancel"))
      << describe(outcome.error());
}

TEST(MeanJob, RefusesAWindowWithoutALength) {
  const auto outcome = mean({.rows = turns({0.0, 1.0}), .options = {.every = 0.0}});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().option, "every");
}

}}  // namespace orispline::jobs
