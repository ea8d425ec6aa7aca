// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <orispline/clip/clip.hpp>

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
