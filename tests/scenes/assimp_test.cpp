// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include <orispline/scenes/scene_file.hpp>

namespace orispline::scenes { namespace {

/// Of Debian's package assimp-testmodels.
struct Model {
  const char* file;
  std::size_t joints, rotations;
  double end;  ///< [s]
};

TEST(Assimp, ReadsFbxAndCollada) {
  const std::filesystem::path models("/usr/share/assimp/models");
  if (!std::filesystem::exists(models)) GTEST_SKIP() << "no " << models;
  for (const Model& model :
       {Model{"FBX/animation_with_skeleton.fbx", 21, 15, 25.0 / 30.0}, Model{"FBX/huesitos.fbx", 16, 10, 1.56},
        Model{"Collada/anims_with_full_rotations_between_keys.DAE", 129, 64, 359.0 / 30.0}}) {
    const auto scene = read_scene(models / model.file);
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->skeleton.size(), model.joints) << model.file;
    ASSERT_EQ(scene->clips.size(), 1u) << model.file;
    EXPECT_EQ(scene->clips[0].rotations.size(), model.rotations) << model.file;
    EXPECT_NEAR(scene->clips[0].domain().end, model.end, 1e-6) << model.file;
  }
}

TEST(Assimp, SaysWhatIsNoFbx) {
  const auto scene = scene_format_of("a.fbx")->read("not an FBX file", "a.fbx", {});
  ASSERT_FALSE(scene);
  EXPECT_TRUE(describe(scene.error()).starts_with("a.fbx: found what assimp cannot read: ")) << describe(scene.error());
}

TEST(Assimp, DoesNotWrite) {
  const auto written = written_scene({}, "a.fbx");
  ASSERT_FALSE(written);
  EXPECT_EQ(describe(written.error()), "a.fbx: FBX files are read only, wanted another format, such as glTF");
}

}}  // namespace orispline::scenes
