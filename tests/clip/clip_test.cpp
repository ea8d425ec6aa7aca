// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/joint_named.hpp>

namespace orispline { namespace {

Skeleton one_joint() { return Skeleton::make({{.name = "hand.r"}}).value(); }

Clip sound_clip() {
  return {.name = "Walking_A",
          .rotations = {{.joint = 0,
                         .times = {0.0, 0.5},
                         .values = {Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()}}}};
}

std::string fault_of(const std::function<void(Clip&)>& spoil) {
  Clip clip = sound_clip();
  spoil(clip);
  const auto checked = check_clip(one_joint(), clip);
  return checked ? "" : describe(checked.error());
}

TEST(JointNamed, TakesNamesThatTellJointsOfOneNameApart) {
  const Skeleton skeleton = Skeleton::make({{.name = "a"},
                                            {.name = "Bone", .parent = 0},
                                            {.name = "a.001"},
                                            {.name = "Bone", .parent = 2},
                                            {.name = "tip", .parent = 3}})
                                .value();
  const auto message = [&](std::string_view name) { return joint_named(skeleton, name).error().message; };
  EXPECT_EQ(joint_named(skeleton, "tip").value(), 4u);
  for (const std::size_t joint : {1u, 3u}) EXPECT_EQ(joint_named(skeleton, skeleton.shown_name(joint)).value(), joint);
  EXPECT_EQ(joint_named(skeleton, "Bone/tip").value(), 4u);
  EXPECT_EQ(message("Bone"), "found 2 joints named 'Bone', wanted one of 'a/Bone', 'a.001/Bone'");
  EXPECT_EQ(message("TIP"), "found 'TIP', wanted the name of a joint; did you mean 'tip'?");
  EXPECT_EQ(message("elbow"), "found 'elbow', wanted the name of a joint");
}

TEST(JointNamed, ChoosesNoneOfThoseThatNothingTellsApart) {
  const Skeleton skeleton =
      Skeleton::make({{.name = "a"}, {.name = "b", .parent = 0}, {.name = "b", .parent = 0}}).value();
  EXPECT_EQ(joint_named(skeleton, "a/b").error().message,
            "found 2 joints named 'a/b', wanted a name of its own for each");
}

TEST(CheckClip, FindsNothingWrongWithASoundClip) {
  EXPECT_EQ(fault_of([](Clip&) {}), "");
}

TEST(CheckClip, NamesClipJointAndKey) {
  const std::string place = "clip 'Walking_A', joint 'hand.r'";
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].times[1] = 0.0; }),
            place + ": key 1: found time 0 after 0, wanted increasing times");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].times[0] = nan; }),
            place + ": key 0: found time nan, wanted a finite number");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].values[1].w() = 2.0; }),
            place + ": key 1: found a quaternion of norm 2, wanted norm 1");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].values[0].x() = nan; }),
            place + ": key 0: found a number that is not finite, wanted finite ones");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].values.pop_back(); }),
            place + ": found 1 values at 2 times, wanted one each");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0].interpolation = ChannelInterpolation::cubicspline; }),
            place + ": found 0 and 0 tangents, wanted 2 each");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations.push_back(c.rotations[0]); }),
            place + ": found a second channel of its rotation, wanted one");
  EXPECT_EQ(fault_of([](Clip& c) { c.rotations[0] = {}; }), place + ": found no key, wanted one at least");
  EXPECT_EQ(fault_of([](Clip& c) {
              c.translations.push_back({.joint = 7, .times = {0}, .values = {{0, 0, 0}}});
            }),
            "clip 'Walking_A': found a channel of joint 7, wanted one of the 1 joints");
}

TEST(Skeleton, WantsParentsFirst) {
  const auto skeleton = Skeleton::make({{.name = "a", .parent = 1}, {.name = "b"}});
  ASSERT_FALSE(skeleton);
  EXPECT_EQ(describe(skeleton.error()), "joint 'a': found joint 1 as its parent, wanted a parent that comes before it");
}

}}  // namespace orispline
