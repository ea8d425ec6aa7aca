// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/edit/clip_edits.hpp>
#include <orispline/edit/seam.hpp>

#include "edit/moving_clips.hpp"

namespace orispline { namespace {

using namespace testing_support;

std::string error_of(const ClipEdits& edits) {
  const auto edit = edited(two_joints(), walk(1.0, 0.0, 0.0), edits);
  return edit ? "none" : edit.error().option + ": " + edit.error().message;
}

TEST(Edited, CutsThenTurnsThenHastensThenShifts) {
  const auto edit =
      edited(two_joints(), walk(1.0, 0.3, 0.0), {.from = 0.21, .to = 0.81, .reverse = true, .speed = 2.0, .shift = 5.0})
          .value();
  EXPECT_EQ(edit.part.start, 0.21);
  EXPECT_EQ(edit.clip.domain().start, 5.0);
  EXPECT_NEAR(edit.clip.domain().end, 5.3, 1e-12);
  EXPECT_FALSE(edit.loop);
}

TEST(Edited, RefusesWhatIsOutsideOfTheClip) {
  EXPECT_EQ(error_of({.from = 1.5}),
            "from: clip 'walk': found 1.5 s, wanted a time of the clip, which is from 0 s to 1 s");
  EXPECT_EQ(error_of({.to = -0.5}),
            "to: clip 'walk': found -0.5 s, wanted a time of the clip, which is from 0 s to 1 s");
  EXPECT_EQ(error_of({.from = 0.7, .to = 0.7}),
            "to: clip 'walk': found a part from 0.7 s to 0.7 s, wanted one that ends later than it starts");
  EXPECT_EQ(error_of({.from = 1.0}),
            "from: clip 'walk': found a part from 1 s to 1 s, wanted one that ends later than it starts");
}

TEST(Edited, RefusesOptionsThatContradictEachOther) {
  EXPECT_EQ(error_of({.period_from = 0.5}), "period_from: found a period without `loop`, wanted both");
  EXPECT_EQ(error_of({.loop = true, .period_from = 0.5, .period_to = 0.4}),
            "period_to: found 0.4 s, wanted no less than `period_from`, which is 0.5 s");
  EXPECT_EQ(error_of({.loop = true, .period_from = 2.0, .period_to = 3.0}),
            "period_from: clip 'walk': found no two keys 2 s to 3 s apart with one between them, wanted a period that "
            "the clip has room for");
  EXPECT_NE(error_of({.speed = 0.0}), "none");
  EXPECT_EQ(error_of({.rate = 1e9}), "rate: clip 'walk': found 1e+09 keys, wanted 1e+07 at most");
}

TEST(Edited, RefusesToCutACubicWhereItIsNoRotation) {
  RotationChannel through_zero{.joint = 1, .interpolation = ChannelInterpolation::cubicspline, .times = {0.0, 1.0}};
  through_zero.values = {Eigen::Quaterniond::Identity(), Eigen::Quaterniond(-Eigen::Quaterniond::Identity().coeffs())};
  through_zero.in_tangents = through_zero.out_tangents = std::vector(2, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0));
  const auto edit = edited(two_joints(), {.name = "through", .rotations = {through_zero}}, {.from = 0.5});
  ASSERT_FALSE(edit);
  EXPECT_EQ(edit.error().code, ErrorCode::bad_data);
}

TEST(SeamOf, NamesTheJointsThatJump) {
  const ClipSeam open = seam_of(walk(0.5, 0.0, 0.0));
  EXPECT_EQ(open.pose.joint, 1u);
  EXPECT_NEAR(open.pose.value, 0.4, 1e-12);
  const ClipSeam closed = seam_of(walk(1.0, 0.0, 0.0));
  EXPECT_LE(closed.pose.value, 1e-12);
  const RotationChannel rest{.joint = 0, .times = {0.0, 1.0}, .values = std::vector(2, turned(0.0, 0.0, 0.0))};
  EXPECT_EQ(seam_of({.rotations = {rest}}).rate.joint, no_parent);
}

}}  // namespace orispline
