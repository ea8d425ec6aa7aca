// SPDX-License-Identifier: Apache-2.0
// The list of families: complete, consistent descriptions, found by name.
#include <orispline/orispline.hpp>

#include <set>

#include <gtest/gtest.h>

#include <orispline/families/families.hpp>

namespace orispline { namespace {

TEST(Registry, DescribesEveryFamilyOnce) {
  std::set<std::string_view> names;
  for (const FamilyInfo& family : families_info()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_FALSE(family.title.empty()) << family.name;
    EXPECT_FALSE(family.source.empty()) << family.name;
    EXPECT_EQ(find_family(family.name).value(), &family);
  }
  EXPECT_EQ(names.size(), std::tuple_size_v<Families>);
}

TEST(Registry, FindsFamiliesByTheirFormerNamesToo) {
  std::set<std::string_view> names;
  for (const FamilyInfo& family : families_info()) names.insert(family.name);
  for (const FamilyInfo& family : families_info()) {
    if (family.alias.empty()) continue;
    EXPECT_TRUE(names.insert(family.alias).second) << family.alias;
    EXPECT_EQ(find_family(family.alias).value(), &family);
  }
  EXPECT_EQ(find_family("family").value()->name, "uniform");
  EXPECT_FALSE(find_family(""));
}

TEST(Registry, HasParametersWithinTheirOwnRanges) {
  for (const FamilyInfo& family : families_info())
    for (const Parameter& parameter : family.parameters) {
      EXPECT_FALSE(parameter.name.empty());
      EXPECT_LE(parameter.lowest, parameter.initial) << family.name;
      EXPECT_LE(parameter.initial, parameter.highest) << family.name;
    }
}

TEST(Registry, IsNoSmootherOnUnevenThanOnEvenTimes) {
  for (const FamilyInfo& family : families_info()) {
    EXPECT_LE(family.continuity_uneven, family.continuity_uniform) << family.name;
    EXPECT_LE(family.keeps_constant_rate_uneven, family.keeps_constant_rate_uniform) << family.name;
    EXPECT_GE(family.min_keys, 2) << family.name;
    EXPECT_TRUE(family.support_keys == all_keys || family.support_keys >= 2) << family.name;
  }
}

TEST(Registry, HasTheDefaultsOfTheSpecification) {
  const auto family = [](std::string_view name) -> const FamilyInfo& { return *find_family(name).value(); };
  EXPECT_EQ(family("quintic").parameters[0].initial, 0.5);
  EXPECT_EQ(family("sextic").parameters[0].initial, 1.0 / 12.0);
  EXPECT_EQ(family("timed-c3").parameters[0].initial, 0.5);
  EXPECT_EQ(family("timed-c3").parameters[1].initial, 1.0);
  EXPECT_EQ(family("timed-c3").parameters[2].initial, 0.0);
  EXPECT_EQ(family("timed-sextic").parameters.size(), 1u);
  EXPECT_EQ(family("quintic").ends.front(), EndRule::repeat);
  EXPECT_EQ(family("timed-c2").ends.front(), EndRule::natural);
  EXPECT_EQ(family("squad").ends.front(), EndRule::key);
  EXPECT_EQ(family("squad-timed").ends.front(), EndRule::reflect);
  EXPECT_TRUE(family("slerp").ends.empty());
}

TEST(Registry, ListsWhatItKnowsWhenAskedForSomethingElse) {
  const auto unknown = find_family("kinematics");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::bad_argument);
  for (const FamilyInfo& family : families_info())
    EXPECT_NE(unknown.error().message.find(family.name), std::string::npos);
}

TEST(Registry, RefusesAPoseCurveAsItRefusesACurve) {
  const Keyframes keys = Keyframes::make({.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}}).value();
  EXPECT_FALSE(make_pose_curve("nlerp", keys));
  EXPECT_FALSE(make_pose_curve({"quintic", {.parameters = {{"tension", {1e9}}}}}, keys));
}

}}  // namespace orispline
