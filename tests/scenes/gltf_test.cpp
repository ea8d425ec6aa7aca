// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "scenes/gltf_file.hpp"
#include "support/places.hpp"

namespace orispline::scenes { namespace {

using test::bytes_of;
using test::GltfFile;
using test::read;

TEST(Gltf, HasNodesAsJointsInAnOrderInWhichParentsComeFirst) {
  GltfFile file;
  file.nodes =
      R"([{"name":"hand","translation":[0,2,0]},{"children":[3,0],"scale":[2,2,2]},{"name":"other"},{"rotation":[0,0,0.6,0.8]}])";
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const Skeleton& skeleton = scene->skeleton;
  ASSERT_EQ(skeleton.size(), 4u);
  EXPECT_EQ(skeleton[0].name, "node 1");
  EXPECT_EQ(skeleton[1].name, "node 3");
  EXPECT_EQ(skeleton[2].name, "hand");
  EXPECT_EQ(skeleton[3].name, "other");
  EXPECT_EQ(skeleton[0].parent, no_parent);
  EXPECT_EQ(skeleton[2].parent, 0u);
  EXPECT_EQ(skeleton[2].rest.translation, Eigen::Vector3d(0, 2, 0));
  EXPECT_EQ(skeleton[0].rest.scale, Eigen::Vector3d(2, 2, 2));
  EXPECT_NEAR(skeleton[1].rest.rotation.z(), 0.6, 1e-15);
  EXPECT_TRUE(scene->clips.empty());
}

TEST(Gltf, TakesAMatrixApart) {
  GltfFile file;
  file.nodes = R"([{"matrix":[0,2,0,0,-3,0,0,0,0,0,4,0,5,6,7,1]},{"matrix":[-1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1]}])";
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const JointPose& turned = scene->skeleton[0].rest;
  EXPECT_TRUE(turned.scale.isApprox(Eigen::Vector3d(2, 3, 4)));
  EXPECT_EQ(turned.translation, Eigen::Vector3d(5, 6, 7));
  EXPECT_TRUE((turned.rotation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
  const JointPose& flat = scene->skeleton[1].rest;
  EXPECT_EQ(flat.scale.z(), 0.0);
  const Eigen::Vector3d point = flat.rotation * flat.scale.cwiseProduct(Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(point.isApprox(Eigen::Vector3d(-1, 2, 0)));
}

TEST(Gltf, ReadsRotationsFromTextAndFromGlb) {
  const GltfFile file = test::turning();
  for (const std::string& content : {file.text(), file.glb()}) {
    const auto scene = read(content);
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_EQ(scene->clips.size(), 1u);
    EXPECT_EQ(scene->clips[0].name, "walk");
    const RotationChannel& channel = scene->clips[0].rotations.at(0);
    EXPECT_EQ(channel.times, (std::vector<double>{0, 1, 2}));
    EXPECT_NEAR(channel.values[1].z(), std::sqrt(0.5), 1e-15);
    EXPECT_EQ(channel.interpolation, ChannelInterpolation::linear);
    EXPECT_EQ(scene->format, &gltf_format);
  }
}

TEST(Gltf, ReadsBuffersFromFilesBesideIt) {
  GltfFile file = test::turning();
  const orispline::test::ScratchDirectory folder;
  std::ofstream(folder.file("a b.bin"), std::ios::binary) << file.binary;
  std::ofstream(folder.file("scene.gltf"))
      << file.json(fmt::format(R"({{"byteLength":{},"uri":"a%20b.bin"}})", file.binary.size()));
  const auto scene = read_scene(folder.file("scene.gltf"));
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->clips[0].rotations[0].size(), 3u);
}

TEST(Gltf, ReadsNormalisedIntegers) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 1});
  const std::vector<std::int16_t> shorts{0, 0, 23170, 23170, 0, 0, -32768, 0};
  file.animate(times,
               file.accessor(R"(,"componentType":5122,"normalized":true,"count":2,"type":"VEC4")", bytes_of(shorts)));
  const std::vector<std::int8_t> bytes{127, -128, 0, 0, -127, 127};
  file.animate(times,
               file.accessor(R"(,"componentType":5120,"normalized":true,"count":2,"type":"VEC3")", bytes_of(bytes)),
               "STEP", "translation");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto& rotations = scene->clips[0].rotations[0].values;
  EXPECT_NEAR(rotations[0].w(), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(rotations[1].z(), -1.0);  // -32768 is -1 too
  const VectorChannel& translation = scene->clips[1].translations.at(0);
  EXPECT_EQ(translation.values[0], Eigen::Vector3d(1, -1, 0));
  EXPECT_EQ(translation.values[1], Eigen::Vector3d(0, -1, 1));
  EXPECT_EQ(translation.interpolation, ChannelInterpolation::step);
}

TEST(Gltf, ReadsSparseElementsOverOthersAndOverZeros) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 1, 2});
  const std::size_t indices = file.view(bytes_of(std::vector<std::uint8_t>{1}));
  const std::size_t values = file.view(bytes_of(std::vector<float>{7, 8, 9}));
  const std::string sparse = fmt::format(
      R"(,"componentType":5126,"count":3,"type":"VEC3","sparse":{{"count":1,"indices":{{"bufferView":{},"componentType":5121}},"values":{{"bufferView":{}}}}})",
      indices, values);
  file.animate(times, file.accessor(sparse, bytes_of(std::vector<float>(9, 1.0F))), "LINEAR", "translation");
  file.accessors.push_back("{" + sparse.substr(1) + "}");
  file.animate(times, file.accessors.size() - 1, "LINEAR", "scale");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto& over_ones = scene->clips[0].translations.at(0).values;
  EXPECT_EQ(over_ones[1], Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(over_ones[2], Eigen::Vector3d(1, 1, 1));
  const auto& over_zeros = scene->clips[1].scales.at(0).values;
  EXPECT_EQ(over_zeros[0], Eigen::Vector3d::Zero());
  EXPECT_EQ(over_zeros[1], Eigen::Vector3d(7, 8, 9));
}

TEST(Gltf, ReadsByAStrideAndWarns) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 1});
  const std::vector<float> spaced{1, 2, 3, 99, 4, 5, 6};
  file.animate(
      times, file.accessor(R"(,"componentType":5126,"count":2,"type":"VEC3")", bytes_of(spaced), R"(,"byteStride":16)"),
      "LINEAR", "translation");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->clips[0].translations[0].values[1], Eigen::Vector3d(4, 5, 6));
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].code, "strided_animation");
  EXPECT_EQ(
      scene->warnings[0].message,
      "1 accessor of animations in a bufferView with a byteStride, which glTF forbids there; they were read by it, "
      "the first is accessor 1");
}

TEST(Gltf, ScalesTangentsAsTheirQuaternion) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0.5F});
  file.animate(times, file.floats("VEC4", {0, 0, 1, 0, 0, 0, 0, 1.01F, 2.02F, 0, 0, 0}), "CUBICSPLINE");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const RotationChannel& channel = scene->clips[0].rotations[0];
  EXPECT_EQ(channel.values[0].w(), 1.0);
  EXPECT_NEAR(channel.in_tangents[0].z(), 1 / 1.01, 1e-7);
  EXPECT_NEAR(channel.out_tangents[0].x(), 2.0, 1e-7);
  EXPECT_EQ(scene->clips[0].domain().end, 0.5);
}

TEST(Gltf, ChannelsWithTheSameKeysShareThem) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 1, 2}), turns = file.floats("VEC4", test::quarter_turns);
  for (const std::size_t from : {times, turns}) file.accessors.push_back(file.accessors[from]);
  const std::size_t others = file.floats("VEC4", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  file.animate(times, turns);
  file.animate(times + 2, turns + 2);
  file.animate(times, others);
  file.animate(times, turns, "STEP");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto channel = [&](std::size_t clip) -> const RotationChannel& { return scene->clips[clip].rotations[0]; };
  EXPECT_TRUE(channel(1).values.shares_with(channel(0).values)) << "accessors of the same bytes";
  for (const std::size_t clip : {1u, 2u, 3u}) EXPECT_TRUE(channel(clip).times.shares_with(channel(0).times));
  EXPECT_FALSE(channel(2).values.shares_with(channel(0).values));
  EXPECT_EQ(channel(3).interpolation, ChannelInterpolation::step);
  EXPECT_EQ(channel(3).values, channel(0).values);
}

TEST(Gltf, KnowsHowLongWhatIsPassedOnLasts) {
  GltfFile file = test::turning();
  const std::size_t times = file.floats("SCALAR", {0.5, 1, 4}), weights = file.floats("SCALAR", {0, 1, 0});
  file.animate(times, weights, "LINEAR", "weights");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_FALSE(scene->clips[0].passed_on);
  EXPECT_EQ(scene->clips[1].whole_domain().start, 0.5);
  EXPECT_EQ(scene->clips[1].whole_domain().end, 4.0);
  file.animate(99, weights, "LINEAR", "weights");
  file.animate(weights, weights, "LINEAR", "weights");
  const auto broken = read(file.text());
  ASSERT_TRUE(broken) << "what is passed on is not read";
  EXPECT_FALSE(broken->clips[2].passed_on);
}

TEST(Gltf, WeightsOfMorphTargetsAreReadThreeToAChannelAndWrittenWhereTheyChange) {
  GltfFile file = test::turning();
  const std::size_t times = file.floats("SCALAR", {0.0, 1.0});
  file.animate(times, file.floats("SCALAR", {0, 0.25, 0.5, 0.75, 1, 0.5, 0.25, 0}), "LINEAR", "weights");
  auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  ASSERT_EQ(scene->clips.at(1).weights.size(), 1U);
  WeightChannels& weights = scene->clips[1].weights[0];
  EXPECT_EQ(weights.count, 4U);
  ASSERT_EQ(weights.triples.size(), 2U);
  EXPECT_EQ(weights.triples[0].values[0], Eigen::Vector3d(0, 0.25, 0.5));
  EXPECT_EQ(weights.triples[1].values[0], Eigen::Vector3d(0.75, 0, 0));
  for (VectorChannel& triple : weights.triples) triple.times[1] = 3.0;
  weights.triples[1].times.insert(weights.triples[1].times.begin() + 1, 1.5);  // a key that the others have not
  weights.triples[1].values.insert(weights.triples[1].values.begin() + 1, Eigen::Vector3d(0.5, 0, 0));
  const auto written = written_scene(*scene, "face.glb");
  ASSERT_TRUE(written) << describe(written.error());
  const auto again = read_scene(io::Input::in_memory("face.glb", written->bytes));
  ASSERT_TRUE(again) << describe(again.error());
  const WeightChannels& back = again->clips.at(1).weights.at(0);
  EXPECT_EQ(back.triples[0].times, (std::vector<double>{0.0, 1.5, 3.0}));
  EXPECT_EQ(back.triples[0].values[1], Eigen::Vector3d(0.5, 0.375, 0.375));
  EXPECT_EQ(back.triples[1].values[1], Eigen::Vector3d(0.5, 0, 0));
}

TEST(Gltf, PassesOverWhatIsNoChannelOfOurs) {
  GltfFile file = test::turning();
  file.animations.clear();
  file.animations.push_back(
      R"({"samplers":[{"input":0,"output":0}],"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}},{"sampler":0,"target":{"path":"pointer"}}]})");
  const auto scene = read(file.text());
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ(scene->clips.at(0).name, "animation 0");
  EXPECT_TRUE(scene->clips[0].rotations.empty());
}

TEST(Gltf, RefusesEqualTimesOrDropsTheLaterKey) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 0.4667F, 0.4667F});
  file.animate(times, file.floats("VEC4", test::quarter_turns));
  EXPECT_EQ(test::said_of(file.text()),
            "scene.gltf: clip 'walk', joint 'arm', key 2: found time 0.4667 after 0.4667, wanted increasing times "
            "(option drop_duplicates)");
  const auto scene = read(file.text(), {.drop_duplicates = true});
  ASSERT_TRUE(scene) << describe(scene.error());
  const RotationChannel& channel = scene->clips[0].rotations[0];
  ASSERT_EQ(channel.size(), 2u);
  EXPECT_NEAR(channel.values[1].z(), std::sqrt(0.5), 1e-15);
}

TEST(Gltf, WarnsOfARequiredExtensionThatIsNotKnown) {
  GltfFile file = test::turning();
  file.more = R"(,"extensionsRequired":["KHR_materials_unlit","ACME_gravity"])";
  EXPECT_EQ(test::said_of(file.text()),
            "extension ACME_gravity is required and not known here; it is passed on unread");
}

TEST(Gltf, ReadsTheRecordingsBesideTheProject) {
  const std::string folder = testing_support::beside_project("data/gltf/");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  const auto mage = read_scene(folder + "kaykit_mage_76clips.glb");
  ASSERT_TRUE(mage) << describe(mage.error());
  EXPECT_EQ(mage->skeleton.size(), 54u);
  ASSERT_EQ(mage->clips.size(), 76u);
  std::size_t rotations = 0, others = 0;
  for (const Clip& clip : mage->clips) {
    rotations += clip.rotations.size();
    others += clip.translations.size() + clip.scales.size();
  }
  EXPECT_EQ(rotations, 3116u);
  EXPECT_EQ(rotations + others, 8712u);
  const auto turning = read_scene(folder + "01_cs_rotate.gltf");
  ASSERT_TRUE(turning) << describe(turning.error());
  const RotationChannel& channel = turning->clips.at(0).rotations.at(0);
  EXPECT_EQ(channel.interpolation, ChannelInterpolation::cubicspline);
  EXPECT_EQ(channel.times, (std::vector<double>{0, 1, 2}));
}

}}  // namespace orispline::scenes
