// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "scenes/bvh_file.hpp"
#include "support/places.hpp"

namespace orispline::scenes { namespace {

TEST(BvhOfGltf, EveryClipHasItsRotationsAndTranslationsInTheFrames) {
  const std::string path = testing_support::beside_project("data/gltf/kaykit_mage_76clips.glb");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  auto scene = read_scene(path);
  ASSERT_TRUE(scene) << describe(scene.error());
  const std::vector<Clip> clips = scene->clips;
  double turned = 0.0, moved = 0.0;
  for (const Clip& clip : clips) {
    scene->clips = {clip};
    const Scene again = test::scene_of(test::text_of(*scene));
    ASSERT_EQ(again.clips.size(), 1u) << clip.name;
    for (const RotationChannel& channel : clip.rotations) {
      const auto joint = again.skeleton.find(scene->skeleton[channel.joint].name);
      ASSERT_TRUE(joint);
      const RotationChannel* found = channel_of(again.clips[0].rotations, *joint);
      ASSERT_TRUE(found);
      const ChannelCurve<Eigen::Quaterniond> curve(channel);
      for (std::size_t k = 0; k < found->size(); ++k)
        turned = std::max(turned, angular_distance(found->values[k], curve.at(found->times[k])));
    }
    for (const VectorChannel& channel : clip.translations) {
      const auto joint = again.skeleton.find(scene->skeleton[channel.joint].name);
      const VectorChannel* found = channel_of(again.clips[0].translations, *joint);
      ASSERT_TRUE(found);
      const ChannelCurve<Eigen::Vector3d> curve(channel);
      for (std::size_t k = 0; k < found->size(); ++k)
        moved = std::max(moved, (found->values[k] - curve.at(found->times[k])).norm());
    }
  }
  // The times of the keys are rounded to `float`: within 1e-7 s the joints turn and move so much.
  EXPECT_LT(turned, 1e-5);
  EXPECT_LT(moved, 1e-5);
}

}}  // namespace orispline::scenes
