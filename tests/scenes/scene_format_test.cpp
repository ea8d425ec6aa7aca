// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/scenes/scene_file.hpp>

namespace orispline::scenes { namespace {

TEST(SceneFormat, IsToldByTheExtensionInAnyCaseOfLetters) {
  EXPECT_EQ(scene_format_of("a/Walk.BVH"), &bvh_format);
  EXPECT_EQ(scene_format_of("mage.glb"), &gltf_format);
  EXPECT_EQ(scene_format_of("mage.gltf"), &gltf_format);
  EXPECT_EQ(scene_format_of("keys.csv"), nullptr);
  EXPECT_EQ(scene_format_of(".bvh"), nullptr);
}

TEST(SceneFormat, OfAnotherExtensionIsAnErrorThatNamesThoseThereAre) {
  const auto scene = read_scene("keys.csv");
  ASSERT_FALSE(scene);
  EXPECT_EQ(describe(scene.error()),
            "keys.csv: found a file of no format that holds a skeleton, wanted one of .bvh, .glb, .gltf");
}

}}  // namespace orispline::scenes
