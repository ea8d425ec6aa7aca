// SPDX-License-Identifier: Apache-2.0
// What the jobs add to the pages of their outcomes.
#include <cmath>

#include <gtest/gtest.h>

#include <jobs/swinging.hpp>
#include <jobs/turns.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/inspect_scene.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/pages/task_pages.hpp>
#include <pages/page_head.hpp>

namespace orispline::jobs { namespace {

Skeleton arm() { return Skeleton::make({{.name = "arm"}, {.name = "hand", .parent = 0}}).value(); }

TEST(SmoothClipsPage, HasTheWarningsAboveItsNotes) {
  SmoothClipsRequest request{.name = "data/arm.bvh",
                             .skeleton = arm(),
                             .clips = {{.name = "wave", .rotations = {swinging(0), swinging(1)}}},
                             .options = {.smoothing_time = 2.0, .gap = 1.5},
                             .has_no_unit = true};
  for (std::size_t i = 0; i < 40; ++i)
    request.clips[0].rotations[1].times[i] += std::floor(static_cast<double>(i) / 2.0);
  const SmoothClipsOutcome outcome = smooth_clips(std::move(request)).value();
  ASSERT_EQ(outcome.warnings.size(), 1U);
  const report::SkeletonPage page = page_of(outcome, "folder/clean.bvh", head);
  EXPECT_EQ(page.title, "arm.bvh smoothed: 1 rotation of 1 clip, 0 samples rejected");
  EXPECT_EQ(page.after, "clean.bvh");
  EXPECT_EQ(page.length_unit, "");
  ASSERT_GE(page.notes.size(), 3U);
  EXPECT_EQ(page.notes[0], head.notes[0]);
  EXPECT_EQ(page.notes[1], "Warning: " + outcome.warnings[0].message + ".");
  EXPECT_EQ(page.notes[2], "The smoothing time is 2 s.");
}

TEST(InspectScenePage, IsThatOfTheFileAlone) {
  const InspectSceneOutcome outcome = inspect_scene(
      {{.name = "data/arm.glb", .skeleton = arm(), .clips = {{.name = "wave", .rotations = {swinging(0)}}}}});
  const report::SkeletonPage page = page_of(outcome, head);
  EXPECT_EQ(page.title, "arm.glb: 2 joints, 1 clip");
  EXPECT_EQ(page.after, "");
  EXPECT_EQ(page.length_unit, "mm");
}

TEST(InspectPage, ShowsTheMethodsThatWereAskedForByTheirLabels) {
  Method tense("quintic"), loose("quintic");
  tense.options.parameters["tension"] = {0.5};
  loose.options.parameters["tension"] = {0.25};
  const InspectOutcome outcome = inspect({.keys = turns({0.0, 0.4, 0.1, 0.7}), .methods = {tense, loose}}).value();
  const report::Page page = page_of(outcome, head);
  EXPECT_EQ(page.title, "arm.csv: 2 methods, 4 keys");
  EXPECT_EQ(page.notes, head.notes);
  ASSERT_EQ(page.methods.size(), 2U);
  EXPECT_EQ(page.methods[0].name, "quintic:tension=0.5");
  EXPECT_EQ(page.methods[0].continuity, "C2");
  EXPECT_GT(page.methods[1].measures.at("peak_rate_rad_s"), 0.4);
}

TEST(InspectPage, ShowsTheMethodThatTheKeysAreForElseTheDefaultOne) {
  for (const auto& [recipe, shown] : {std::pair{"", "auto"}, {"timed-c3", "timed-c3"}}) {
    const report::Page page = page_of(inspect({.keys = turns({0.0, 0.4, 0.1, 0.7}, recipe)}).value(), head);
    ASSERT_EQ(page.methods.size(), 1U);
    EXPECT_EQ(page.methods[0].name, shown);
    EXPECT_EQ(page.methods[0].failure, "");
    EXPECT_EQ(page.title, std::string("arm.csv: ") + shown + ", 4 keys");
  }
}

TEST(InspectPage, SaysWhyThereIsNoCurveAndWhatIsWrongWithTheKeys) {
  const InspectOutcome outcome =
      inspect({.keys = turns({0.0, 0.4, 0.1, 0.7}, "no-such-method"), .faults = {.defect = "key 2: no"}}).value();
  const report::Page page = page_of(outcome, head);
  ASSERT_EQ(page.methods.size(), 1U);
  EXPECT_NE(page.methods[0].failure.find("no-such-method"), std::string::npos) << page.methods[0].failure;
  EXPECT_EQ(page.notes.back(), "Warning: the keys were mended for this page; other commands say: key 2: no.");
}

TEST(InspectPage, HasNoCurveInTheGapsThatTheKeysState) {
  Track track = turns_of({0.0, 0.1, 0.3, 0.2, 0.5, 0.4});
  KeyframeData data = track.keys.data();
  for (std::size_t i = 3; i < 6; ++i) data.times[i] += 10.0;
  track.keys = Keyframes::make(std::move(data)).value();
  track.recipe.gap = 2.0;
  const report::Page page = page_of(inspect({.keys = std::make_shared<const Track>(track)}).value(), head);
  const report::PageSamples& samples = page.methods.at(0).samples;
  for (std::size_t i = 0; i < samples.path.times.size(); ++i)
    EXPECT_EQ(std::isnan(samples.path.orientations[i].w()),
              samples.path.times[i] > 2.0 && samples.path.times[i] < 13.0);
}

}}  // namespace orispline::jobs
