// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/difference.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

/// One joint that turns about z by this angle in two seconds [rad].
Clip turned(std::string name, double angle) {
  RotationChannel channel{.joint = 0, .times = {0.0, 1.0, 2.0}};
  for (const double part : {0.0, 0.5, 1.0})
    channel.values.emplace_back(Eigen::AngleAxisd(part * angle, Eigen::Vector3d::UnitZ()));
  return {.name = std::move(name), .rotations = {std::move(channel)}};
}

MotionFile motion(std::string name, std::vector<Clip> clips) {
  return {.name = std::move(name), .skeleton = Skeleton::make({{.name = "head"}}).value(), .clips = std::move(clips)};
}

TEST(DifferenceJob, ComparesClipsOfTheSameNameAtTheirKeys) {
  const auto outcome = difference({.first = motion("a.glb", {turned("nod", 0.1), turned("wave", 0.2)}),
                                   .second = motion("b.glb", {turned("wave", 0.25), turned("walk", 0.1)})})
                           .value();
  ASSERT_EQ(outcome.clips.size(), 1u);
  EXPECT_EQ(outcome.name_of(outcome.clips[0]), "wave");
  EXPECT_EQ(outcome.clips[0].times, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_NEAR(outcome.clips[0].worst[0].angle.value, 0.05, 1e-12);
  EXPECT_EQ(outcome.only_in_first, std::vector<std::string>{"nod"});
  EXPECT_EQ(outcome.only_in_second, std::vector<std::string>{"walk"});
}

TEST(DifferenceJob, ComparesTheOnlyClipsWhateverTheirNames) {
  EXPECT_TRUE(
      difference({.first = motion("a.glb", {turned("nod", 0.1)}), .second = motion("b.glb", {turned("x", 0.1)})}));
  const auto none = difference({.first = motion("a.glb", {turned("nod", 0.1), turned("wave", 0.2)}),
                                .second = motion("b.glb", {turned("x", 0.1)})});
  ASSERT_FALSE(none);
  EXPECT_EQ(describe(none.error()), "b.glb: found no clip of the same name, wanted one at least");
}

TEST(DifferenceJob, ComparesBetweenTheKeysToo) {
  DifferenceRequest request{
      .first = motion("a.glb", {turned("nod", 0.1)}), .second = motion("b.glb", {turned("nod", 0.1)}), .rate = 4.0};
  EXPECT_EQ(difference(request).value().clips[0].times.size(), 9u);
  request.rate = 1e9;
  EXPECT_EQ(difference(request).error().option, "rate");
}

TEST(DifferenceJob, FindsTheLargestBetweenTheTimesOfARate) {
  DifferenceRequest request{.first = motion("a.glb", {turned("nod", 0.0)}),
                            .second = motion("b.glb", {turned("nod", 0.0)})};
  RotationChannel& swing = request.second.clips[0].rotations[0];
  swing.times[1] = 0.87;
  swing.values[1] = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(difference(request).value().clips[0].worst[0].angle.value, 0.3 * 1.0 / 1.13, 1e-12);
  request.rate = 3.0;
  const LargestInTime found = difference(request).value().clips[0].worst[0].angle;
  EXPECT_NEAR(found.value, 0.3, 1e-6);
  EXPECT_NEAR(found.time, 0.87, 1e-6);
}

TEST(DifferenceJob, SaysWhatIsGuessedAndWhatIsMissing) {
  MotionFile first = motion("a.glb", {turned("nod", 0.1), turned("nod", 0.2)}),
             second = motion("b.glb", {turned("nod", 0.1), turned("nod", 0.2), turned("nod", 0.4)});
  first.skeleton = Skeleton::make({{.name = "head"},
                                   {.name = "ear", .parent = 0},
                                   {.name = "ear", .parent = 0},
                                   {.name = "hat", .parent = 0},
                                   {.name = "jaw", .parent = 0}})
                       .value();
  second.skeleton = Skeleton::make({{.name = "head"},
                                    {.name = "ear", .parent = 0},
                                    {.name = "ear", .parent = 0},
                                    {.name = "mouth", .parent = 0},
                                    {.name = "jaw", .parent = 3}})
                        .value();
  const auto outcome = difference({.first = first, .second = second}).value();
  ASSERT_EQ(outcome.warnings.size(), 2u);
  EXPECT_EQ(describe(outcome.warnings[0]),
            "a.glb: found 2 clips whose name others have too, such as 'nod'; by their order it was guessed which they "
            "are in the second file");
  EXPECT_EQ(describe(outcome.warnings[1]),
            "a.glb: found 2 joints whose name others have too, such as 'head/ear'; by their order it was guessed which "
            "they are in the second file");
  const std::string summary = summary_of(outcome);
  EXPECT_NE(summary.find("only in a.glb: 1 joint, such as 'hat'\nonly in b.glb: 1 joint, such as 'mouth'\n"
                         "by name alone, below other joints: 1 joint, such as 'jaw'\n"),
            std::string::npos)
      << summary;
  const Json document = document_of(outcome);
  EXPECT_EQ(std::get<std::uint64_t>(member(document, "joints_only_in_first").value()), 1u);
  EXPECT_EQ(std::get<std::uint64_t>(member(document, "joints_only_in_second").value()), 1u);
  EXPECT_TRUE(difference({.first = first, .second = first}).value().warnings.size() == 2u);
  first.clips.pop_back();
  second.clips.resize(1);
  EXPECT_EQ(difference({.first = first, .second = second}).value().warnings.size(), 1u);
}

TEST(DifferenceJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome =
      difference({.first = motion("a.glb", {turned("nod", 0.1)}), .second = motion("b.glb", {turned("nod", 0.3)})})
          .value();
  EXPECT_NEAR(number(document_of(outcome), "angle_max_deg"), 0.2 * degrees, 1e-9);
  const std::string summary = summary_of(outcome);
  EXPECT_TRUE(
      summary.starts_with("a.glb and b.glb: 1 clip compared\nlargest angle        11.4592°, clip 'nod', joint 'head', "
                          "at 2 s\n"))
      << summary;
}

}}  // namespace orispline::jobs
