// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <orispline/scenes/scene_units.hpp>

#include "bvh_file.hpp"

namespace orispline::scenes { namespace {

using test::scene_of;

Scene a_walk() {
  return scene_of(
      "HIERARCHY\nROOT hips\n{\nOFFSET 0 90 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
      "JOINT knee\n{\nOFFSET 10 -40 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 -50 3\n}\n}\n}\n"
      "MOTION\nFrames: 2\nFrame Time: 0.5\n0 90 0 0 0 0 10 0 0\n100 95 -20 0 5 0 0 20 0\n");
}

TEST(SceneUnits, GltfIsWrittenInMetres) {
  const auto written = written_scene(a_walk(), "walk.glb", {.position_scale = 0.01});
  ASSERT_TRUE(written) << describe(written.error());
  const auto read = read_scene(io::Input::in_memory("walk.glb", written->bytes));
  ASSERT_TRUE(read) << describe(read.error());
  constexpr double of_float = 1e-7;
  const auto rest = [&](std::string_view joint) {
    return read->skeleton[read->skeleton.find(joint).value()].rest.translation;
  };
  EXPECT_LT((rest("knee") - Eigen::Vector3d(0.1, -0.4, 0)).norm(), of_float);
  EXPECT_LT((rest("knee_End") - Eigen::Vector3d(0, -0.5, 0.03)).norm(), of_float);
  const VectorChannel& way = read->clips[0].translations[0];
  EXPECT_LT((way.values[0] - Eigen::Vector3d(0, 0.9, 0)).norm(), of_float);
  EXPECT_LT((way.values[1] - Eigen::Vector3d(1, 0.95, -0.2)).norm(), of_float);
}

TEST(SceneUnits, TangentsAreLengthsAndScalesAreNot) {
  Scene scene = a_walk();
  Clip& clip = scene.clips[0];
  VectorChannel& way = clip.translations[0];
  way.interpolation = ChannelInterpolation::cubicspline;
  way.in_tangents = way.out_tangents = std::vector<Eigen::Vector3d>(2, {1, 2, 3});
  clip.scales.push_back({.joint = 1, .times = way.times, .values = std::vector<Eigen::Vector3d>(2, {1, 2, 1})});
  const auto scaled = in_metres(scene, 0.0254);
  ASSERT_TRUE(scaled) << describe(scaled.error());
  const Clip& made = scaled->clips[0];
  for (const auto& tangents : {made.translations[0].in_tangents, made.translations[0].out_tangents})
    for (std::size_t key = 0; key < 2; ++key)
      EXPECT_LT((tangents[key] - Eigen::Vector3d(0.0254, 0.0508, 0.0762)).norm(), 1e-15);
  EXPECT_EQ(made.scales[0].values[1], Eigen::Vector3d(1, 2, 1));
  EXPECT_EQ(scene.clips[0].translations[0].in_tangents[0], Eigen::Vector3d(1, 2, 3));
}

TEST(SceneUnits, FilesInMetresAndOutputsWithoutAUnitTakeNone) {
  const auto fault = [](const Scene& scene, const std::string& path, double metres) {
    const auto written = written_scene(scene, path, {.position_scale = metres});
    return written ? std::string() : written.error().option + ": " + written.error().message;
  };
  EXPECT_EQ(
      fault(a_walk(), "walk.bvh", 0.01),
      "position_scale: found an output that is a BVH file, which has no unit of length and keeps that of the input, "
      "wanted glTF");
  for (const double metres :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_NE(fault(a_walk(), "walk.glb", metres).find("wanted a number above 0"), std::string::npos) << metres;
  Scene in_gltf = a_walk();
  in_gltf.format = &gltf_format;
  EXPECT_EQ(
      fault(in_gltf, "walk.glb", 0.01),
      "position_scale: found a glTF file, whose lengths are in metres, wanted a file without a unit, such as BVH");
  in_gltf.format = nullptr;
  EXPECT_EQ(fault(in_gltf, "walk.glb", 0.01),
            "position_scale: found keys, whose lengths are in metres, wanted a file without a unit, such as BVH");
}

}  // namespace

}  // namespace orispline::scenes
