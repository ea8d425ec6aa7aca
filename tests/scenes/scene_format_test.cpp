// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <io/text_file.hpp>
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
            "keys.csv: found a file of no format that holds a skeleton, wanted one of .bvh, .glb, .gltf, .vrm, .vrma");
}

constexpr std::size_t gigabytes = std::size_t{1} << 31;  // less than what is read at most, and much of no file

struct Start {
  const SceneFormat* format;
  std::string bytes, said;  // nothing said: the rest is worth reading
};

TEST(SceneFormat, IsToldByTheBeginningOfALargeFileBeforeTheRestIsRead) {
  using namespace std::string_literals;
  const std::string zeros(4096, '\0'), blanks(4096, ' '),
      no_json = "found text that is not valid JSON, wanted a glTF document";
  const std::string sound = "glTF\2\0\0\0\0\0\0\x70\4\0\0\0JSON{}  "s;
  const auto with = [&](std::size_t at, std::string_view part) {
    return std::string(sound).replace(at, part.size(), part);
  };
  for (const Start& start :
       std::vector<Start>{{&gltf_format, sound, ""},
                          {&gltf_format, zeros, no_json},
                          {&gltf_format, blanks, ""},
                          {&gltf_format, "\xEF\xBB\xBF\n {", ""},
                          {&gltf_format, "HIERARCHY", no_json},
                          {&gltf_format, with(4, "\1"), "found GLB version 1, wanted 2"},
                          {&gltf_format, with(11, "\xFF"),
                           "found a GLB of 2147483648 bytes that states 4278190080, wanted a whole one"},
                          {&gltf_format, with(15, "\x70"),
                           "found a chunk of 1879048196 bytes at byte 12, wanted at most the 1879048172 that follow"},
                          {&gltf_format, with(16, "BIN\0"s), "found a GLB without a JSON chunk, wanted it first"},
                          {&bvh_format, "\n hierarchy\nROOT", ""},
                          {&bvh_format, blanks, ""},
                          {&bvh_format, blanks + "HIERAR", ""},
                          {&bvh_format, zeros, "walk:1: found '" + std::string(40, '?') + "...', wanted HIERARCHY"},
                          {&bvh_format, "\n{\"asset\"", "walk:2: found '{', wanted HIERARCHY"}}) {
    const auto checked = start.format->check_start(start.bytes, gigabytes, "walk");
    EXPECT_EQ(checked ? "" : describe(checked.error()), start.said) << start.bytes.substr(0, 40);
  }
}

TEST(SceneFormat, RefusesALargeFileByItsBeginning) {
  const orispline::test::ScratchDirectory folder;
  for (const char* const name : {"zeros.glb", "zeros.gltf", "zeros.bvh"}) {
    std::ofstream(folder.file(name)) << "no such file";
    std::filesystem::resize_file(folder.file(name), 3 << 20);
    EXPECT_EQ(read_scene(folder.file(name)).error().code, ErrorCode::bad_data) << name;
  }
}

}}  // namespace orispline::scenes
