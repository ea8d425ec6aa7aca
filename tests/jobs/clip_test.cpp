// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/clip.hpp>

#include <gtest/gtest.h>

#include "edit/moving_clips.hpp"

namespace orispline::jobs { namespace {

using namespace testing_support;

MotionFile file_with(std::vector<Clip> clips) {
  return {.name = "take.glb", .skeleton = two_joints(), .clips = std::move(clips)};
}

Clip named(std::string name, Clip clip) {
  clip.name = std::move(name);
  return clip;
}

std::string error_of(ClipRequest request) {
  const auto outcome = clip(std::move(request));
  return outcome ? "none" : describe(outcome.error());
}

TEST(ClipJob, EditsEveryClip) {
  const auto outcome = clip({.file = file_with({named("a", walk(1.0, 0.2, 0.0)), named("b", walk(2.0, 0.2, 0.0))}),
                             .edits = {.from = 0.25, .shift = 0.0}})
                           .value();
  ASSERT_EQ(outcome.clips.size(), 2u);
  EXPECT_EQ(outcome.clips[1].clip.name, "b");
  EXPECT_EQ(outcome.clips[1].clip.domain().end, 1.75);
  EXPECT_EQ(outcome.seams[1].pose.joint, 1u);
  EXPECT_NE(summary_of(outcome).find("'a': 0 s to 0.75 s, from 0.25 s to 1 s of the input"), std::string::npos);
}

TEST(ClipJob, SaysHowALoopWasClosed) {
  ClipRequest request{.file = file_with({walk(1.0, 0.2, 0.1)}), .edits = {.loop = true}, .root = "hips"};
  const auto outcome = clip(request).value();
  const ClipLoop& loop = outcome.clips[0].loop.value();
  EXPECT_EQ(loop.closing, LoopClosing::bent);
  EXPECT_EQ(loop.rotation.joint, 1u);
  EXPECT_NEAR(loop.turn, 0.1, 1e-8);
  EXPECT_LE(outcome.seams[0].pose.value, 1e-9) << "but for the turn of the root";
  EXPECT_NE(summary_of(outcome).find("largest change"), std::string::npos);
}

TEST(ClipJob, NamesTheFileAndTheOptionOfWhatIsWrong) {
  EXPECT_EQ(error_of({.file = file_with({})}), "take.glb: found no clip, wanted one");
  EXPECT_EQ(error_of({.file = file_with({walk(1.0, 0.0, 0.0)}), .edits = {.loop = true}, .root = "hip"}),
            "take.glb: root: found 'hip', wanted the name of a joint; did you mean 'hips'?");
  EXPECT_EQ(error_of({.file = file_with({walk(1.0, 0.0, 0.0)}), .edits = {.from = 3.0}}),
            "take.glb: from: clip 'walk': found 3 s, wanted a time of the clip, which is from 0 s to 1 s");
  EXPECT_EQ(error_of({.file = file_with({walk(1.0, 0.0, 0.0)}), .root = "hips"}),
            "take.glb: root: found a joint whose way goes on, wanted `loop` or `append` too");
}

/// A clip of one key.
Clip pose() {
  Clip clip{.name = "pose"};
  clip.rotations = {{.joint = 1, .times = {0.0}, .values = {turned(0.3, 0.0, 0.0)}}};
  return clip;
}

TEST(ClipJob, LeavesClipsThatAnEditDoesNotFitAndSaysWhich) {
  for (const ClipEdits& edits : {ClipEdits{.loop = true}, ClipEdits{.to = 0.5}}) {
    const auto outcome = clip({.file = file_with({named("pose", pose()), named("a", walk(1.0, 0.2, 0.0))}),
                               .edits = edits,
                               .root = edits.loop ? "hips" : ""})
                             .value();
    ASSERT_EQ(outcome.clips.size(), 2u);
    EXPECT_EQ(outcome.clips[0].clip.rotations[0].size(), 1u);
    EXPECT_EQ(outcome.clips[1].loop.has_value(), edits.loop);
    ASSERT_EQ(outcome.warnings.size(), 1u);
    EXPECT_EQ(outcome.warnings[0].code, "clips_left");
    EXPECT_EQ(outcome.warnings[0].number("clips"), 1.0);
    EXPECT_NE(outcome.warnings[0].message.find("1 of 2 clips stay as they are"), std::string::npos);
    EXPECT_NE(outcome.warnings[0].message.find("'pose'"), std::string::npos);
  }
}

TEST(ClipJob, RefusesWhatFitsNoClip) {
  EXPECT_EQ(error_of({.file = file_with({named("pose", pose()), named("other", pose())}), .edits = {.loop = true}}),
            "take.glb: clip 'pose': found keys at 1 time, wanted 3 at least for a loop");
}

TEST(ClipJob, WarnsOfValuesThatOnlyTheFormatKnows) {
  Clip with_weights = walk(1.0, 0.0, 0.0);
  with_weights.passed_on = Domain{0.0, 1.0};
  const auto outcome = clip({.file = file_with({with_weights}), .edits = {.from = 0.5}}).value();
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_EQ(outcome.warnings[0].code, "values_not_edited");
}

}}  // namespace orispline::jobs
