// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <random>

#include <orispline/clip/compressed_bytes.hpp>
#include <orispline/clip/filtered_keys.hpp>
#include <orispline/scenes/gltf/meshopt.hpp>

#include "scenes/gltf_written.hpp"

namespace orispline::scenes { namespace {

using gltf::Json;
using test::GltfFile;

constexpr std::string_view extension = "EXT_meshopt_compression";

Eigen::Quaterniond turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// A joint that turns, moves and grows, with values rounded for the filters; splines where `is_spline`.
Scene rounded_scene(bool is_spline, double farthest) {
  Scene scene;
  scene.skeleton = Skeleton::make({{.name = "arm"}}).value();
  Clip clip{.name = "walk"};
  RotationChannel rotation{.joint = 0};
  VectorChannel translation{.joint = 0};
  for (int i = 0; i < 40; ++i) {
    const double t = i / 30.0;
    rotation.times.push_back(static_cast<double>(static_cast<float>(t)));
    rotation.values.push_back(turned(3.0 * std::sin(2.0 * t), {1.0, t, -0.3}));
    translation.values.push_back({std::sin(3.0 * t), 0.9 + 0.1 * std::cos(5.0 * t), 0.02 * t});
    if (!is_spline) continue;
    rotation.in_tangents.push_back(Eigen::Quaterniond(0.1 * t, std::cos(t), -std::sin(t), 0.4));
    translation.in_tangents.push_back({std::cos(t), -3.0 * t, 1.0});
  }
  if (is_spline) {
    rotation.interpolation = translation.interpolation = ChannelInterpolation::cubicspline;
    rotation.out_tangents = rotation.in_tangents;
    translation.out_tangents = translation.in_tangents;
  }
  translation.times = rotation.times;
  clip.rotations.push_back(with_fewest_bits(rotation, farthest));
  clip.translations.push_back(with_fewest_bits(translation, farthest));
  scene.clips.push_back(std::move(clip));
  return scene;
}

SceneWritten compressed(const Scene& scene) {
  auto written = written_scene(scene, "out.glb", {.compression = KeyCompression::meshopt, .bones = false});
  EXPECT_TRUE(written) << describe(written.error());
  return *std::move(written);
}

struct Parts {
  Json json;
  std::string binary;

  explicit Parts(std::string_view bytes) {
    const auto parts = gltf::container_of(bytes).value();
    json = gltf::parsed(parts.json).value();
    binary = std::string(parts.binary.value_or(""));
  }
  [[nodiscard]] std::string glb() const { return gltf::glb_of(json.dump(), binary).value(); }
};

Expected<Scene> read_glb(const std::string& bytes) { return read_scene(io::Input::in_memory("scene.glb", bytes)); }

template <CurvePoint P>
double farthest(const SharedList<P>& a, const SharedList<P>& b) {
  double most = a.size() == b.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      most = std::max(most, std::min((a[i].coeffs() - b[i].coeffs()).norm(), (a[i].coeffs() + b[i].coeffs()).norm()));
    else most = std::max(most, (a[i] - b[i]).norm());
  }
  return most;
}

class GltfMeshopt : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_meshopt()) GTEST_SKIP() << "this build is without meshoptimizer";
  }
};

TEST(GltfWithoutMeshopt, SaysWhatDecodes) {
  EXPECT_NE(without_meshopt().find("gltf-transform copy"), std::string::npos);
  EXPECT_EQ(check(KeyCompression::meshopt).has_value(), has_meshopt());
  const auto into_bvh = written_scene(rounded_scene(false, 1e-3), "a.bvh", {.compression = KeyCompression::meshopt});
  ASSERT_FALSE(into_bvh);
  EXPECT_EQ(into_bvh.error().message, "found an output that is a BVH file, wanted glTF");
}

TEST_F(GltfMeshopt, RoundedKeysComeBackAsTheyAre) {
  const Scene scene = rounded_scene(false, 2e-3);
  const SceneWritten written = compressed(scene);
  const Parts file(written.bytes);
  EXPECT_EQ(file.json["extensionsRequired"], Json::array({extension}));
  EXPECT_EQ(file.json["extensionsUsed"], Json::array({extension}));
  ASSERT_EQ(file.json["buffers"].size(), 2u);
  EXPECT_EQ(file.json["buffers"][1]["extensions"][std::string(extension)], Json({{"fallback", true}}));
  std::vector<std::string> filters;
  for (const Json& view : file.json["bufferViews"]) {
    EXPECT_EQ(view["buffer"], 1);
    filters.push_back(view["extensions"][std::string(extension)].value("filter", "NONE"));
  }
  EXPECT_EQ(filters, (std::vector<std::string>{"NONE", "QUATERNION", "EXPONENTIAL"}));
  const auto again = read_glb(written.bytes);
  ASSERT_TRUE(again) << describe(again.error());
  EXPECT_LE(farthest(again->clips[0].rotations[0].values, scene.clips[0].rotations[0].values), 2.0 / 32767.0);
  EXPECT_EQ(farthest(again->clips[0].translations[0].values, scene.clips[0].translations[0].values), 0.0);
}

TEST_F(GltfMeshopt, RoundedSplinesComeBackAsTheyAre) {
  const Scene scene = rounded_scene(true, 2e-3);
  const Parts file(compressed(scene).bytes);
  for (const Json& accessor : file.json["accessors"]) EXPECT_EQ(accessor["componentType"], 5126);
  for (const Json& view : file.json["bufferViews"]) {
    const Json& compression = view["extensions"][std::string(extension)];
    EXPECT_EQ(compression.value("filter", "NONE"), compression["byteStride"] == 4 ? "NONE" : "EXPONENTIAL");
  }
  const auto again = read_glb(file.glb());
  ASSERT_TRUE(again) << describe(again.error());
  const RotationChannel &now = again->clips[0].rotations[0], &before = scene.clips[0].rotations[0];
  EXPECT_LE(farthest(now.values, before.values), 1e-15);
  EXPECT_LE(farthest(now.in_tangents, before.in_tangents), 1e-14);
  EXPECT_LE(farthest(now.out_tangents, before.out_tangents), 1e-14);
  EXPECT_EQ(farthest(again->clips[0].translations[0].in_tangents, scene.clips[0].translations[0].in_tangents), 0.0);
}

TEST_F(GltfMeshopt, WhatIsNotRoundedKeepsItsBits) {
  const auto scene = test::read(test::turning().text());
  ASSERT_TRUE(scene);
  const auto again = read_glb(compressed(*scene).bytes);
  ASSERT_TRUE(again) << describe(again.error());
  EXPECT_EQ(farthest(again->clips[0].rotations[0].values, scene->clips[0].rotations[0].values), 0.0);
  const auto plain = written_scene(*again, "out.glb");
  ASSERT_TRUE(plain);
  const Parts file(plain->bytes);
  EXPECT_FALSE(file.json.contains("extensionsUsed"));
  EXPECT_FALSE(file.json.contains("extensionsRequired"));
  EXPECT_EQ(file.json["buffers"].size(), 1u);
}

TEST_F(GltfMeshopt, DataThatLieAreRefused) {
  const Parts sound(compressed(rounded_scene(false, 2e-3)).bytes);
  const auto said = [&](const std::function<void(Json & view, Json & compression)>& change, std::size_t index = 1) {
    Parts file = sound;
    Json& view = file.json["bufferViews"][index];
    change(view, view["extensions"][std::string(extension)]);
    const auto scene = read_glb(file.glb());
    return scene ? std::string("read") : orispline::test::text_of(scene.error());
  };
  const std::string place = "scene.glb: EXT_meshopt_compression of bufferView 1: ";
  EXPECT_EQ(said([](Json&, Json& c) { c["mode"] = "TRIANGLES"; }),
            place + "found mode 'TRIANGLES' for data of animations, wanted ATTRIBUTES");
  EXPECT_EQ(said([](Json&, Json& c) { c["count"] = 39; }),
            place + "found 39 elements of 8 bytes, wanted the 320 bytes of the bufferView");
  EXPECT_EQ(said([](Json&, Json& c) { c["byteStride"] = 6; }),
            place + "found a byteStride of 6, wanted a multiple of 4 up to 256");
  EXPECT_EQ(said([](Json&, Json& c) { c["byteStride"] = 0; }),
            place + "found a byteStride of 0, wanted a multiple of 4 up to 256");
  EXPECT_EQ(said([](Json&, Json& c) { c["byteStride"] = 16, c["count"] = 20; }),
            place + "found a byteStride of 16 for filter 'QUATERNION', wanted 8");
  EXPECT_EQ(said([](Json&, Json& c) { c["filter"] = "COLOR"; }),
            place + "found filter 'COLOR', wanted NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL");
  EXPECT_EQ(said([](Json&, Json& c) { c["buffer"] = 1; }),
            place + "found buffer 1, which has no data, wanted one that has");
  EXPECT_NE(said([](Json&, Json& c) { c["byteLength"] = 100000; }).find("found 100000 bytes from byte"),
            std::string::npos);
  EXPECT_EQ(said([](Json&, Json& c) { c["byteLength"] = c["byteLength"].get<std::size_t>() - 4; }),
            place +
                "found data that are damaged or of a newer codec, wanted those of version 0; gltf-transform copy "
                "IN.glb OUT.glb decodes a sound file");
  EXPECT_NE(said([](Json& v, Json& c) { c["count"] = 4000000, v["byteLength"] = 32000000; }).find("wanted"),
            std::string::npos);
  EXPECT_EQ(said([&](Json&, Json& c) {
              c["byteOffset"] = sound.json["bufferViews"][0]["extensions"][std::string(extension)]["byteOffset"];
            }),
            place + "found data that are those of another bufferView too, wanted some of its own");
  EXPECT_EQ(said([](Json& v, Json&) {
              v["extensions"] = {{std::string(extension), 3}};
            }),
            place + "found 3, wanted an object");
}

TEST_F(GltfMeshopt, CompressedMeshesAreCarriedAsTheyAre) {
  GltfFile file = test::turning();
  const std::string mesh = "sixteen bytes..!";
  file.view(mesh);  // in the place of compressed bytes, which nothing here decodes
  file.views.push_back(
      R"({"buffer":1,"byteOffset":8,"byteLength":64,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
      std::to_string(file.binary.size() - mesh.size()) +
      R"(,"byteLength":16,"byteStride":4,"count":16,"mode":"ATTRIBUTES"}}})");
  file.accessors.push_back(R"({"bufferView":3,"componentType":5126,"count":5,"type":"VEC3"})");
  file.more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":2}}]}],"extensionsUsed":["EXT_meshopt_compression"],"extensionsRequired":["EXT_meshopt_compression"])";
  const std::string text = file.json(fmt::format(
      R"({{"byteLength":{},"uri":"data:;base64,{}"}},{{"byteLength":72,"extensions":{{"EXT_meshopt_compression":{{"fallback":true}}}}}})",
      file.binary.size(), base64_of(file.binary)));
  const auto scene = test::read(text);
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->next_tool, extension);
  const auto written = written_scene(*scene, "out.glb");
  ASSERT_TRUE(written) << describe(written.error());
  const Parts after(written->bytes);
  const Json& view = after.json["bufferViews"][3];
  const Json& compression = view["extensions"][std::string(extension)];
  EXPECT_EQ(view["buffer"], 1);
  EXPECT_EQ(view["byteLength"], 64);
  EXPECT_EQ(compression["buffer"], 0);
  EXPECT_EQ(after.binary.substr(compression["byteOffset"].get<std::size_t>(), 16), mesh);
  EXPECT_EQ(after.json["buffers"].size(), 2u);
  EXPECT_EQ(after.json["extensionsRequired"], Json::array({extension}));
}

TEST_F(GltfMeshopt, RotationsAreDecodedAsByTheLibrary) {
  std::mt19937 random(7);
  std::normal_distribution<double> part;
  for (int bits = fewest_bits; bits <= most_bits; ++bits) {
    std::vector<FilteredQuaternion> stored;
    for (int i = 0; i < 200; ++i)
      stored.push_back(
          filtered(Eigen::Quaterniond(part(random), part(random), part(random), part(random)).normalized(), bits));
    const std::string_view bytes(reinterpret_cast<const char*>(stored.data()), 8 * stored.size());
    const auto read =
        gltf::from_meshopt(gltf::to_meshopt(bytes, 8), {stored.size(), 8, gltf::MeshoptFilter::quaternion});
    ASSERT_TRUE(read);
    for (std::size_t i = 0; i < stored.size(); ++i) {
      FilteredQuaternion theirs{};
      std::memcpy(theirs.data(), read->data() + 8 * i, 8);
      const FilteredQuaternion ours = decoded(stored[i]);
      for (std::size_t k = 0; k < ours.size(); ++k) EXPECT_LE(std::abs(ours[k] - theirs[k]), 1) << bits << " bits";
    }
  }
}

TEST_F(GltfMeshopt, SizesAreForetold) {
  const Scene scene = rounded_scene(false, 1e-3);
  std::string bytes;
  for (int i = 0; i < 20; ++i)
    for (const Eigen::Quaterniond& value : std::as_const(scene.clips[0].rotations[0].values))
      for (const std::int16_t number : filtered(value, 12)) bytes.append(reinterpret_cast<const char*>(&number), 2);
  const std::size_t found = gltf::to_meshopt(bytes, 8).size();
  const std::size_t foretold = compressed_size({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, 8);
  EXPECT_NEAR(static_cast<double>(foretold), static_cast<double>(found), 0.05 * static_cast<double>(found));
}

}}  // namespace orispline::scenes
