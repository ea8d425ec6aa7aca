// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <orispline/base/base64.hpp>

#include "scenes/gltf_written.hpp"
#include "support/places.hpp"

namespace orispline::scenes { namespace {

using gltf::Json;
using test::bytes_of;
using test::GltfFile;
using test::read;
using test::refusal;
using test::scene_of;
using test::written;
using test::WrittenFile;

/// One joint that turns, from no file.
Scene made_scene(std::vector<double> times, std::vector<Eigen::Quaterniond> values) {
  Scene scene;
  scene.skeleton = Skeleton::make({Joint{.name = "craft"}}).value();
  scene.clips.push_back({.name = "turn", .rotations = {{.times = std::move(times), .values = std::move(values)}}});
  return scene;
}

const Eigen::Quaterniond no_turn = Eigen::Quaterniond::Identity(), half_turn{0.0, 0.0, 0.0, 1.0};
const Eigen::Quaterniond quarter_turn{std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};

TEST(GltfWriter, KeepsBitsAndWhatItDoesNotKnow) {
  GltfFile file;
  const std::size_t mesh = file.floats("VEC3", {1, 2, 3, 4, 5, 6, 7, 8, 9});
  const std::size_t times = file.floats("SCALAR", {0, 1, 2});
  const std::vector<float> values{0.1F, 0.2F, 0.3F, 0.92736F, 0, 0, 0.70710677F, 0.70710677F, 0, 0, 0.3F, 0.95F};
  file.animate(times, file.floats("VEC4", values));
  file.more = fmt::format(
      R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"extras":{{"a":[1.5,null]}},"scene":0,"scenes":[{{"nodes":[0]}}])",
      mesh);
  const Json before = gltf::parsed(file.text()).value();
  for (const std::string_view name : {"out.glb", "out.gltf"}) {
    const WrittenFile after = written(scene_of(file), name);
    for (const char* key : {"asset", "meshes", "extras", "scene", "scenes", "nodes"})
      EXPECT_EQ(after.json[key], before[key]);
    EXPECT_EQ(after.json["animations"][0]["channels"], before["animations"][0]["channels"]);
    EXPECT_EQ(after.json["animations"][0]["name"], "walk");
    EXPECT_EQ(after.json["accessors"].size(), 3u);
    if (name == "out.gltf") continue;
    EXPECT_EQ(after.accessor_bytes(0, 12), bytes_of<float>({1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(after.accessor_bytes(after.json["animations"][0]["samplers"][0]["output"], 16), bytes_of(values));
  }
}

TEST(GltfWriter, TakesReducedKeysOutOfTheBinaryAndRenumbersNothing) {
  GltfFile file;
  std::vector<float> times(100), values;
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<float>(i) / 64;
    values.insert(values.end(), {0, 0, std::sin(times[i]), std::cos(times[i])});
  }
  const std::size_t input = file.floats("SCALAR", times);
  file.animate(input, file.floats("VEC4", values));
  const std::size_t output = file.floats("VEC4", values) - 1;  // of the first
  const std::size_t mesh = file.floats("VEC3", {1, 2, 3});
  file.animations[0] =
      R"({"samplers":[{"input":0,"output":1},{"input":0,"output":2}],"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}]})";
  file.more = fmt::format(R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}])", mesh);
  EXPECT_EQ(output, 1u);
  Scene scene = scene_of(file);
  RotationChannel& channel = scene.clips[0].rotations[0];
  channel.times = {channel.times.front(), channel.times.back()};
  channel.values = {channel.values.front(), channel.values.back()};
  const WrittenFile after = written(scene);
  EXPECT_EQ(after.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"], 3);
  EXPECT_EQ(after.json["accessors"].size(), 4u);
  EXPECT_EQ(after.json["accessors"][3]["bufferView"], 3);
  EXPECT_EQ(after.accessor_bytes(3, 12), bytes_of<float>({1, 2, 3}));
  EXPECT_EQ(after.json["accessors"][2]["count"], 1);  // a place that is filled
  EXPECT_LE(after.binary.size(), 12u + 2 * (4 + 16) + 8);
}

TEST(GltfWriter, TakesKeysOutOfAViewThatOthersShare) {
  GltfFile file;
  const std::vector<float> all{0, 1, 2, /* keys */ 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, /* a mesh */ 7, 8, 9, 0, 1, 2};
  file.view(bytes_of(all));
  const auto part = [&](std::size_t offset, std::size_t count, std::string_view type) {
    file.accessors.push_back(fmt::format(
        R"({{"bufferView":0,"byteOffset":{},"componentType":5126,"count":{},"type":"{}"}})", 4 * offset, count, type));
  };
  part(0, 3, "SCALAR");
  part(3, 3, "VEC4");
  part(15, 2, "VEC3");
  file.animate(0, 1);
  file.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":2}}]}])";
  Scene scene = scene_of(file);
  scene.clips.clear();
  const WrittenFile after = written(scene);
  EXPECT_FALSE(after.json.contains("animations"));
  EXPECT_EQ(after.json["accessors"].size(), 3u);
  EXPECT_EQ(after.accessor_bytes(2, 12), bytes_of<float>({7, 8, 9, 0, 1, 2}));
  EXPECT_EQ(after.binary.size(), 28u);  // 4 before it, for the same place within 8 bytes
}

TEST(GltfWriter, KeepsWhatFollowsAnOddNumberOfBytesOnItsPlaceWithinEight) {
  GltfFile file;
  file.view("image");
  file.animate(file.floats("SCALAR", {0, 1, 2}), file.floats("VEC4", test::quarter_turns));
  const std::size_t second = file.view("second image");
  file.more = fmt::format(R"(,"images":[{{"bufferView":0}},{{"bufferView":{}}}])", second);
  Scene scene = scene_of(file);
  scene.clips.clear();
  const WrittenFile after = written(scene);
  const auto image = [&](std::size_t i) {
    return after.json["bufferViews"][after.json["images"][i]["bufferView"].get<std::size_t>()];
  };
  EXPECT_EQ(after.binary.substr(image(0).value("byteOffset", 0u), 5), "image");
  const std::size_t offset = image(1)["byteOffset"];
  EXPECT_EQ(after.binary.substr(offset, 12), "second image");
  EXPECT_EQ(offset, 12u);  // was 68
}

TEST(GltfWriter, KeepsKeysThatAMeshOrASkinNamesToo) {
  for (const char* const also : {R"(,"meshes":[{"primitives":[{"attributes":{},"indices":0}]}])",
                                 R"(,"skins":[{"joints":[0],"inverseBindMatrices":0}])",
                                 R"(,"meshes":[{"primitives":[{"attributes":{"_WAVE":0}}]}])",
                                 R"(,"meshes":[{"primitives":[{"attributes":{},"targets":[{"POSITION":0}]}]}])"}) {
    GltfFile file = test::turning();
    file.more = also;
    Scene scene = scene_of(file);
    scene.clips.clear();
    const WrittenFile after = written(scene);
    EXPECT_EQ(after.accessor_bytes(0, 4), bytes_of<float>({0, 1, 2})) << also;
    EXPECT_EQ(after.binary.size(), 12u) << also;
  }
}

TEST(GltfWriter, KeepsChannelsThatAreNotOurs) {
  GltfFile file = test::turning();
  const std::size_t weights = file.floats("SCALAR", {0, 0.5F, 1});
  file.animations[0] = fmt::format(
      R"({{"extras":7,"samplers":[{{"input":0,"output":1}},{{"input":0,"output":{}}}],"channels":[{{"sampler":0,"target":{{"node":0,"path":"rotation"}},"extras":"ours"}},{{"sampler":1,"target":{{"node":0,"path":"weights"}}}}]}})",
      weights);
  const WrittenFile after = written(scene_of(file));
  const Json& animation = after.json["animations"][0];
  EXPECT_EQ(animation["extras"], 7);
  EXPECT_EQ(animation["channels"][0]["extras"], "ours");
  const Json& sampler = animation["samplers"][animation["channels"][1]["sampler"].get<std::size_t>()];
  EXPECT_EQ(sampler["output"], weights);
  EXPECT_EQ(after.accessor_bytes(weights, 4), bytes_of<float>({0, 0.5F, 1}));
  EXPECT_EQ(sampler["input"], 0);
}

TEST(GltfWriter, RemovesTheAnimationsOfClipsThatWentByTheirNames) {
  GltfFile file = test::turning();
  file.animations.push_back(R"({"name":"run","samplers":[],"channels":[],"extras":1})");
  file.animations.push_back(R"({"name":"jump","samplers":[],"channels":[],"extras":2})");
  Scene scene = scene_of(file);
  scene.clips.erase(scene.clips.begin() + 1);
  const WrittenFile after = written(scene);
  ASSERT_EQ(after.json["animations"].size(), 2u);
  EXPECT_EQ(after.json["animations"][0]["name"], "walk");
  EXPECT_EQ(after.json["animations"][1]["extras"], 2);
}

TEST(GltfWriter, MergesBuffers) {
  GltfFile file = test::turning();
  const std::string second = base64_of(bytes_of<float>({3, 2, 1}));
  file.views.push_back(R"({"buffer":1,"byteLength":12})");
  file.accessors.push_back(R"({"bufferView":2,"componentType":5126,"count":1,"type":"VEC3"})");
  const std::string buffers = fmt::format(
      R"({{"byteLength":{},"uri":"data:;base64,{}","name":"keys"}},{{"byteLength":12,"uri":"data:application/gltf-buffer;base64,{}"}})",
      file.binary.size(), base64_of(file.binary), second);
  const auto scene = read(file.json(buffers));
  ASSERT_TRUE(scene) << describe(scene.error());
  const WrittenFile after = written(*scene);
  ASSERT_EQ(after.json["buffers"].size(), 1u);
  EXPECT_EQ(after.json["buffers"][0], Json({{"name", "keys"}, {"byteLength", after.binary.size()}}));
  EXPECT_EQ(after.accessor_bytes(2, 12), bytes_of<float>({3, 2, 1}));
}

TEST(GltfWriter, RefusesDataThatOnlyAnExtensionKnows) {
  GltfFile file = test::turning();
  file.view("abcd", R"(,"extensions":{"XYZ_packed":{"buffer":0}})");
  EXPECT_EQ(refusal(scene_of(file)),
            "out.glb: bufferView 2: found data that only an extension can read, wanted an uncompressed bufferView");
}

TEST(GltfWriter, MakesADocumentWithACraftForALoneJoint) {
  const WrittenFile after = written(made_scene({0.25, 1.5}, {no_turn, half_turn}));
  EXPECT_EQ(after.json["asset"], Json({{"version", "2.0"}, {"generator", "orispline"}}));
  EXPECT_EQ(after.json["nodes"], Json::array({{{"name", "craft"}, {"mesh", 0}}}));
  EXPECT_EQ(after.json["scenes"][0]["nodes"], Json::array({0}));
  const Json& corners = after.json["accessors"][1];
  EXPECT_FLOAT_EQ(corners["max"][0].get<float>() - corners["min"][0].get<float>(), 1.0F);
  const Json& sampler = after.json["animations"][0]["samplers"][0];
  const std::size_t input = sampler["input"], output = sampler["output"];
  EXPECT_EQ(after.json["accessors"][input]["min"], Json::array({0.25}));
  EXPECT_EQ(after.json["accessors"][input]["max"], Json::array({1.5}));
  EXPECT_EQ(after.accessor_bytes(output, 16), bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 0}));
}

TEST(GltfWriter, MakesBonesToTheFarthestChild) {
  Scene scene;
  scene.skeleton =
      Skeleton::make({Joint{.name = "root"}, Joint{.name = "near", .parent = 0, .rest = {.translation = {0, 1, 0}}},
                      Joint{.name = "far", .parent = 0, .rest = {.translation = {0, 0, 3}}}})
          .value();
  const WrittenFile after = written(scene);
  EXPECT_EQ(after.json["nodes"][0]["children"], Json::array({1, 2}));
  EXPECT_EQ(after.json["nodes"][2], Json({{"name", "far"}, {"translation", {0.0, 0.0, 3.0}}}));
  ASSERT_EQ(after.json["meshes"].size(), 1u);
  EXPECT_EQ(after.json["accessors"][1]["max"][2], 3.0);
  for (const Json& view : after.json["bufferViews"]) EXPECT_EQ(view["buffer"], 0);
  const orispline::test::ScratchDirectory folder;
  ASSERT_TRUE(write_scene(scene, folder.file("bare.gltf"), {.bones = false}));
  const std::string bare = orispline::test::content_of(folder.file("bare.gltf"));
  EXPECT_EQ(bare.find("mesh"), std::string::npos);
  EXPECT_TRUE(bare.starts_with("{\n  \"")) << "indented by two";
}

TEST(GltfWriter, AlignsSignsButLeavesSplinesTheCurvesThatTheyAre) {
  Scene scene =
      made_scene({0, 1, 2}, {no_turn, Eigen::Quaterniond(Eigen::Vector4d(-quarter_turn.coeffs())), half_turn});
  const WrittenFile linear = written(scene);
  EXPECT_TRUE(linear.warnings.empty());
  const std::size_t output = linear.json["animations"][0]["samplers"][0]["output"];
  EXPECT_EQ(linear.accessor_bytes(output, 16), bytes_of(test::quarter_turns));
  RotationChannel& channel = scene.clips[0].rotations[0];
  channel.interpolation = ChannelInterpolation::cubicspline;
  channel.in_tangents = channel.out_tangents = {Eigen::Quaterniond(1, 0, 0, 0), Eigen::Quaterniond(2, 0, 0, 0),
                                                Eigen::Quaterniond(3, 0, 0, 0)};
  const WrittenFile spline = written(scene);
  const Json& sampler = spline.json["animations"][0]["samplers"][0];
  EXPECT_EQ(sampler["interpolation"], "CUBICSPLINE");
  EXPECT_EQ(spline.accessor_bytes(sampler["output"], 16).substr(std::size_t{4} * 16, 16),
            bytes_of<float>({-0.0F, -0.0F, -0.70710677F, -0.70710677F}));
  EXPECT_EQ(spline.accessor_bytes(sampler["output"], 16).substr(std::size_t{3} * 16, 16),
            bytes_of<float>({0, 0, 0, 2}));
  EXPECT_TRUE(spline.warnings.empty());
}

TEST(GltfWriter, SharesEqualKeysAndKeepsOneOfWhatDoesNotMoveButNotTheEnd) {
  Scene scene = made_scene({0.5, 1, 2}, {quarter_turn, quarter_turn, quarter_turn});
  Clip& clip = scene.clips[0];
  clip.translations = {{.times = {0.5, 1}, .values = {{1, 2, 3}, {1, 2, 4}}}};
  clip.scales = {{.interpolation = ChannelInterpolation::cubicspline,
                  .times = {0.5, 1},
                  .values = {{1, 1, 1}, {1, 1, 1}},
                  .in_tangents = {{0, 0, 0}, {0, 0, 0}},
                  .out_tangents = {{0, 0, 0}, {0, 0, 0}}}};
  scene.clips.push_back(clip);
  const WrittenFile after = written(scene);
  const Json& animation = after.json["animations"][0];
  EXPECT_EQ(animation["samplers"], after.json["animations"][1]["samplers"]);
  const auto count_of = [&](std::size_t sampler) {
    return after.json["accessors"][animation["samplers"][sampler]["input"].get<std::size_t>()]["count"];
  };
  EXPECT_EQ(count_of(0), 2);  // at 0.5 and 2, the end of the clip
  EXPECT_EQ(count_of(1), 2);
  EXPECT_EQ(count_of(2), 1);
  EXPECT_FALSE(animation["samplers"][2].contains("interpolation"));
}

TEST(GltfWriter, RefusesTimesThatSinglePrecisionCannotTellApart) {
  EXPECT_EQ(
      refusal(made_scene({100, 100.000001}, {no_turn, half_turn})),
      "out.glb: clip 'turn', joint 'craft', key 1: found time 100.000001 after 100, which are 100 and 100 in single "
      "precision, wanted increasing times");
  EXPECT_EQ(refusal(made_scene({-1, 1}, {no_turn, half_turn})),
            "out.glb: clip 'turn', joint 'craft', key 0: found time -1, wanted one from 0 on");
}

TEST(GltfWriter, TakesTheMatrixOfAnAnimatedNodeApart) {
  GltfFile file = test::turning();
  file.nodes =
      R"([{"name":"arm","matrix":[0,2,0,0,-3,0,0,0,0,0,4,0,5,6,7,1],"extras":1},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}])";
  const Scene scene = scene_of(file);
  EXPECT_EQ(scene.skeleton[0].rest.translation, Eigen::Vector3d(5, 6, 7));
  const Json nodes = written(scene).json["nodes"];
  EXPECT_FALSE(nodes[0].contains("matrix"));
  EXPECT_EQ(nodes[0]["translation"], (std::vector<double>{5, 6, 7}));
  EXPECT_EQ(nodes[0]["scale"], (std::vector<double>{2, 3, 4}));
  EXPECT_NEAR(nodes[0]["rotation"][2].get<double>(), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(nodes[0]["extras"], 1);
  EXPECT_TRUE(nodes[1].contains("matrix"));  // nothing of it moves
}

TEST(GltfWriter, LeavesOutAClipWithoutKeysAndSaysSo) {
  Scene scene = made_scene({0, 1}, {no_turn, half_turn});
  scene.clips.push_back({.name = "nothing"});
  const WrittenFile after = written(scene);
  EXPECT_EQ(after.json["animations"].size(), 1u);
  ASSERT_EQ(after.warnings.size(), 1u);
  EXPECT_EQ(after.warnings[0].message, "clip 'nothing' has no keys and is left out, for glTF has no such animation");
}

TEST(GltfWriter, WritesTheRecordingBesideTheProjectAsItWas) {
  const std::string path = testing_support::beside_project("data/gltf/kaykit_mage_76clips.glb");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto scene = read_scene(path);
  ASSERT_TRUE(scene) << describe(scene.error());
  const std::string bytes = orispline::test::content_of(path);
  const auto parts = gltf::container_of(bytes);
  WrittenFile before{gltf::parsed(parts->json).value(), std::string(*parts->binary), {}};
  WrittenFile after = written(*scene);
  for (std::size_t i = 0; i < 61; ++i) {                                                    // of meshes and skins
    const std::size_t size = before.json["accessors"][i]["componentType"] == 5123 ? 2 : 4;  // of its first component
    EXPECT_EQ(before.json["accessors"][i], after.json["accessors"][i]);
    EXPECT_EQ(before.accessor_bytes(i, size), after.accessor_bytes(i, size));
  }
  for (const char* key : {"animations", "accessors", "bufferViews", "buffers"}) {
    before.json.erase(key);
    after.json.erase(key);
  }
  EXPECT_EQ(before.json, after.json);
}

}}  // namespace orispline::scenes
