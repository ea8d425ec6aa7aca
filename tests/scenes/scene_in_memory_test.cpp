// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "scenes/gltf_file.hpp"

namespace orispline::scenes { namespace {

using io::Input;
using test::GltfFile;

const GltfFile arm = test::turning();
const std::string with_buffer_beside =
    arm.json("{\"byteLength\":" + std::to_string(arm.binary.size()) + ",\"uri\":\"the%20keys.bin\"}");

TEST(SceneInMemory, IsReadAsThatOfAFile) {
  const std::string glb = arm.glb();
  const Scene scene = read_scene(Input::in_memory("arm.glb", glb)).value();
  EXPECT_EQ(scene.name, "arm.glb");
  EXPECT_EQ(scene.bytes, glb.size());
  ASSERT_EQ(scene.clips.size(), 1u);
  EXPECT_EQ(scene.clips[0].rotations[0].times.size(), 3u);
  EXPECT_EQ(describe(read_scene(Input::in_memory("arm.glb", "")).error()), "arm.glb: empty: no skeleton");
  EXPECT_EQ(read_scene(Input::in_memory("-", glb)).error().code, ErrorCode::bad_argument);  // a name of no format
}

TEST(SceneInMemory, FindsTheFilesThatAreGivenWithIt) {
  const auto scene =
      read_scene(Input::in_memory("arm.gltf", with_buffer_beside, {Input::in_memory("the keys.bin", arm.binary)}));
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->clips[0].rotations[0].times.size(), 3u);
  EXPECT_EQ(scene->bytes, with_buffer_beside.size() + arm.binary.size());
}

TEST(SceneInMemory, LooksForNoOtherFiles) {
  EXPECT_EQ(describe(read_scene(Input::in_memory("arm.gltf", with_buffer_beside)).error()),
            "arm.gltf: buffer 0: found uri 'the%20keys.bin', which is not given, wanted the bytes within the document, "
            "as a .glb has them");
}

TEST(SceneInMemory, HoldsTracks) {
  join_formats();
  const auto track = io::read_track(Input::in_memory("arm.glb", arm.glb()));
  ASSERT_TRUE(track) << describe(track.error());
  EXPECT_EQ(track->track.keys.size(), 3u);
}

TEST(SceneInMemory, IsNamedWhereAJointIsNotInIt) {
  join_formats();
  const auto track = io::read_track(Input::in_memory("arm.glb", arm.glb()), {.scene = {.joint = "leg"}});
  ASSERT_FALSE(track);
  EXPECT_EQ(track.error().where.file, "arm.glb");
}

}}  // namespace orispline::scenes
