// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_difference.hpp>

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace orispline { namespace {

using Joints = std::vector<std::size_t>;

/// A joint that is so far along x from its parent.
Joint joint(std::string name, std::size_t parent, double x = 0.0) {
  return {.name = std::move(name), .parent = parent, .rest = {.translation = Eigen::Vector3d(x, 0.0, 0.0)}};
}

Skeleton skeleton(std::vector<Joint> joints) { return Skeleton::make(std::move(joints)).value(); }

/// Two armatures whose bones have the same names.
Skeleton armatures() {
  return skeleton({joint("scene", no_parent), joint("Armature", 0), joint("Bone", 1), joint("Tip", 2),
                   joint("Armature.001", 0), joint("Bone", 4), joint("Tip", 5)});
}

TEST(Counterparts, GoByNamesAndByTheirOrderWhereNamesAreEqual) {
  const Skeleton a = skeleton({{.name = "x"}, {.name = "y"}, {.name = "x"}, {.name = "only here"}});
  const Skeleton b = skeleton({{.name = "y"}, {.name = "x"}, {.name = "x"}});
  const Counterparts found = counterparts_of(a, b);
  EXPECT_EQ(found.joints, (Joints{1, 0, 2, no_parent}));
  EXPECT_EQ(found.guessed, (Joints{0, 2}));
  EXPECT_EQ(found.only_in_first, 1u);
  EXPECT_EQ(found.only_in_second, 0u);
}

TEST(Counterparts, GoByThePathBeforeTheName) {
  const Skeleton turned = skeleton({joint("scene", no_parent), joint("Armature.001", 0), joint("Bone", 1),
                                    joint("Tip", 2), joint("Armature", 0), joint("Bone", 4), joint("Tip", 5)});
  const Counterparts found = counterparts_of(armatures(), turned);
  EXPECT_EQ(found.joints, (Joints{0, 4, 5, 6, 1, 2, 3}));
  EXPECT_TRUE(found.guessed.empty() && found.by_name.empty());
}

TEST(Counterparts, AreFoundByTheirNamesWhereTheTreeIsAnother) {
  const Skeleton lifted = skeleton({joint("world", no_parent), joint("Armature.001", 0), joint("Bone", 1),
                                    joint("Tip", 2), joint("Armature", 0), joint("Bone", 4), joint("Nail", 5)});
  const Counterparts found = counterparts_of(armatures(), lifted);
  EXPECT_EQ(found.joints, (Joints{no_parent, 4, 5, no_parent, 1, 2, 3}));
  EXPECT_EQ(found.by_name, (Joints{1, 4})) << "what is below them is at its place";
  EXPECT_TRUE(found.guessed.empty());
  EXPECT_EQ(found.only_in_first, 2u);
  EXPECT_EQ(found.only_in_second, 2u);
}

TEST(Counterparts, OfOneNameAtOnePlaceAreThoseThatLookAlike) {
  const Skeleton a = skeleton({joint("root", no_parent), joint("arm", 0, 1.0), joint("hand", 1), joint("arm", 0, 1.0),
                               joint("hook", 3), joint("arm", 0, 2.0)});
  const Skeleton b = skeleton({joint("root", no_parent), joint("arm", 0, 2.0), joint("arm", 0, 1.0), joint("hook", 2),
                               joint("arm", 0, 1.0), joint("hand", 4)});
  const Counterparts found = counterparts_of(a, b);
  EXPECT_EQ(found.joints, (Joints{0, 4, 5, 2, 3, 1}));
  EXPECT_TRUE(found.guessed.empty());
}

TEST(Counterparts, TellWhatIsGuessed) {
  const Skeleton a = skeleton({joint("root", no_parent), joint("arm", 0, 1.0), joint("arm", 0, 2.0)});
  const Skeleton b = skeleton({joint("root", no_parent), joint("arm", 0, 3.0), joint("arm", 0, 4.0)});
  const Counterparts found = counterparts_of(a, b);
  EXPECT_EQ(found.joints, (Joints{0, 1, 2}));
  EXPECT_EQ(found.guessed, (Joints{1, 2}));
}

TEST(Counterparts, AreGuessedAmongThoseThatLookAlike) {
  const Skeleton a = skeleton({joint("root", no_parent), joint("arm", 0, 1.0), joint("arm", 0, 1.0),
                               joint("arm", 0, 2.0), joint("arm", 0, 2.0)});
  const Skeleton b = skeleton({joint("root", no_parent), joint("arm", 0, 2.0), joint("arm", 0, 2.0),
                               joint("arm", 0, 1.0), joint("arm", 0, 1.0)});
  const Counterparts found = counterparts_of(a, b);
  EXPECT_EQ(found.joints, (Joints{0, 3, 4, 1, 2}));
  EXPECT_EQ(found.guessed, (Joints{1, 2, 3, 4}));
}

TEST(Counterparts, AreGuessedWhereSeveralOfOneNameAreElsewhere) {
  const Skeleton a = skeleton(
      {joint("root", no_parent), joint("left", 0), joint("hand", 1, 1.0), joint("right", 0), joint("hand", 3, 1.0)});
  const Skeleton b = skeleton(
      {joint("root", no_parent), joint("front", 0), joint("hand", 1, 2.0), joint("back", 0), joint("hand", 3, 2.0)});
  const Counterparts found = counterparts_of(a, b);
  EXPECT_EQ(found.joints, (Joints{0, no_parent, 2, no_parent, 4}));
  EXPECT_EQ(found.guessed, (Joints{2, 4}));
}

TEST(Counterparts, AreTheSameInAnyOrderOfTheJoints) {
  std::vector<Joint> joints{joint("root", no_parent)};
  std::mt19937 dice(7);
  for (std::size_t i = 1; i < 60; ++i)
    joints.push_back(joint(std::string(1, static_cast<char>('a' + i % 2)), dice() % i, static_cast<double>(i)));
  const Skeleton a = skeleton(joints);
  for (int round = 0; round < 20; ++round) {
    Joints order{0}, place(joints.size());
    std::vector<Joint> shuffled{joints[0]};
    while (order.size() < joints.size()) {
      const std::size_t next = dice() % joints.size();
      const bool is_there = std::ranges::find(order, next) != order.end();
      const auto parent = std::ranges::find(order, joints[next].parent);
      if (is_there || parent == order.end()) continue;
      place[next] = order.size();
      shuffled.push_back(joints[next]);
      shuffled.back().parent = static_cast<std::size_t>(parent - order.begin());
      order.push_back(next);
    }
    const Counterparts found = counterparts_of(a, skeleton(shuffled));
    EXPECT_EQ(found.joints, place);
    EXPECT_TRUE(found.guessed.empty() && found.by_name.empty());
  }
}

TEST(Counterparts, OfNothingAreNothing) {
  EXPECT_TRUE(counterparts_of(Skeleton(), Skeleton()).joints.empty());
  EXPECT_EQ(counterparts_of(Skeleton(), armatures()).only_in_second, 7u);
  EXPECT_EQ(counterparts_of(armatures(), Skeleton()).only_in_first, 7u);
}

TEST(ShownName, IsThePathWhereOthersHaveTheName) {
  const Skeleton both = armatures();
  EXPECT_EQ(both.shown_name(1), "Armature");
  EXPECT_EQ(both.shown_name(2), "scene/Armature/Bone");
  EXPECT_EQ(both.shown_name(6), "scene/Armature.001/Bone/Tip");
  EXPECT_EQ(place_of(both, {.name = "nod"}, 5), "clip 'nod', joint 'scene/Armature.001/Bone'");
  std::vector<Joint> chain{joint("b", no_parent)};
  for (std::size_t i = 0; i < 8; ++i) chain.push_back(joint("b", i));
  EXPECT_EQ(skeleton(chain).shown_name(5), "b/b/b/b/b/b");
  EXPECT_EQ(skeleton(chain).shown_name(8), "…/b/b/b/b/b/b");
}

}}  // namespace orispline
