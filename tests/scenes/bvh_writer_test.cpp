// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "scenes/bvh_file.hpp"
#include "support/places.hpp"

namespace orispline::scenes { namespace {

using test::frames_of;
using test::made_scene;
using test::one_joint;
using test::scene_of;
using test::text_of;
using test::turn_about;
using test::turning;
using test::write_bvh;

using std::numbers::pi;

std::string hierarchy_of(const std::string& text) { return text.substr(0, text.find("MOTION")); }

std::string line_of(const std::string& text, std::string_view begin) {
  const std::size_t at = text.find(begin);
  return at == std::string::npos ? "" : text.substr(at, text.find_first_of("\r\n", at) - at);
}

/// A joint that stands still at these times.
Scene standing(std::vector<double> times) {
  const std::size_t keys = times.size();
  return turning(std::move(times), std::vector<Eigen::Quaterniond>(keys, Eigen::Quaterniond::Identity()));
}

std::vector<std::string> warnings_of(const Expected<SceneWritten>& written) {
  std::vector<std::string> texts;
  if (!written) return {describe(written.error())};
  for (const Warning& warning : written->warnings) texts.push_back(describe(warning));
  return texts;
}

TEST(BvhWriter, WhatWasReadIsWrittenWithEveryDigitOfHierarchyAndAngles) {
  const std::string text =
      "HIERARCHY\r\nROOT Left Hip\r\n{\r\n OFFSET 1.50 -0.0 3e0\r\n CHANNELS 6 Xposition Zrotation Yposition Xrotation "
      "Zposition Yrotation\r\n JOINT knee\r\n {\r\n\tOFFSET 0.10 0 0\r\n\tCHANNELS 1 Xrotation\r\n\tEnd Site\r\n\t{\r\n"
      "\tOFFSET 0 1.000 0\r\n\t}\r\n }\r\n}\r\n";
  const std::string motion =
      "MOTION\r\nFrames: 3\r\nFrame Time: 0.0083333\r\n1 170 2 90 3 -720.5 0.1\r\n1 -170 2 90 3 45 0.2\r\n"
      "1 -171 2.25 89.99999 3 45 400\r\n";
  EXPECT_EQ(text_of(scene_of(text + motion)), text + motion);
}

TEST(BvhWriter, AJointThatChangedFollowsWithoutJumpsAndTheOthersStay) {
  Scene scene =
      scene_of(one_joint("CHANNELS 3 Zrotation Xrotation Yrotation", "350 10 20\n10 10 20\n30 10 20\n", "Frames: 3\n"));
  scene.clips[0].rotations[0].values[2] = turn_about(pi / 2, Eigen::Vector3d::UnitZ());
  const auto frames = frames_of(text_of(scene));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_NEAR(frames[0][0], 350, 1e-9);
  EXPECT_NEAR(frames[1][0], 370, 1e-9);
  EXPECT_NEAR(frames[2][0], 450, 1e-9);
  EXPECT_NEAR(frames[2][1], 0, 1e-9);
}

TEST(BvhWriter, OneOrTwoTurnsStayWhereTheyAreEnoughElseThereAreThree) {
  Scene scene = scene_of(one_joint("CHANNELS 2 Xrotation Zrotation", "0 0\n10 20\n", "Frames: 2\n"));
  SharedList<Eigen::Quaterniond>& values = scene.clips[0].rotations[0].values;
  values[1] = turn_about(-1.0, Eigen::Vector3d::UnitX()) * turn_about(3.0, Eigen::Vector3d::UnitZ());
  std::string text = text_of(scene);
  EXPECT_EQ(line_of(text, "CHANNELS"), "CHANNELS 2 Xrotation Zrotation");
  EXPECT_NEAR(frames_of(text)[1][0], -180 / pi, 1e-12);
  EXPECT_NEAR(frames_of(text)[1][1], 3 * 180 / pi, 1e-12);
  values[1] = turn_about(1.0, Eigen::Vector3d::UnitY());
  text = text_of(scene);
  EXPECT_EQ(line_of(text, "CHANNELS"), "CHANNELS 3 Zrotation Yrotation Xrotation");
  EXPECT_EQ(line_of(text, "OFFSET"), "OFFSET 1 2 3");
  EXPECT_NEAR(frames_of(text)[1][1], 180 / pi, 1e-12);
}

TEST(BvhWriter, APositionThatHasNoChannelGetsAllThree) {
  Scene scene = scene_of(one_joint("CHANNELS 2 Xrotation Yposition", "5 7\n", "Frames: 1\n"));
  EXPECT_EQ(frames_of(text_of(scene))[0], (std::vector<double>{5, 7}));
  scene.clips[0].translations[0].values[0].z() = 4;
  const std::string text = text_of(scene);
  EXPECT_EQ(line_of(text, "CHANNELS"), "CHANNELS 4 Xposition Yposition Zposition Xrotation");
  EXPECT_EQ(frames_of(text)[0], (std::vector<double>{1, 7, 4, 5}));
}

TEST(BvhWriter, TheOrderThatIsAskedForIsThatOfAllJoints) {
  const Scene scene = scene_of(one_joint("CHANNELS 4 Zrotation Yposition Xrotation Yrotation", "10 0 20 30\n"));
  const std::string text = text_of(scene, {.euler = euler_order_of("XYZ")});
  EXPECT_EQ(line_of(text, "CHANNELS"), "CHANNELS 4 Yposition Xrotation Yrotation Zrotation");
  EXPECT_EQ(line_of(text_of(scene, {.euler = euler_order_of("zyx")}), "CHANNELS"),
            "CHANNELS 4 Yposition Xrotation Yrotation Zrotation");
  const Scene again = scene_of(text);
  EXPECT_LT(angular_distance(again.clips[0].rotations[0].values[0], scene.clips[0].rotations[0].values[0]), 1e-15);
  const auto refused = write_bvh(scene, {.euler = euler_order_of("ZXZ")});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().option, "output_euler");
}

TEST(BvhWriter, ASceneFromElsewhereBecomesAHierarchyOfItsAnimatedJoints) {
  const Eigen::Quaterniond quarter = turn_about(pi / 2, Eigen::Vector3d::UnitX());
  const Scene scene = made_scene({{.name = "camera"},
                                  {.name = "hip bone", .rest = {.translation = {0, 1, 0}}},
                                  {.name = "mesh", .parent = 1},
                                  {.name = "knee", .parent = 1, .rest = {.translation = {0, -0.5, 0}}},
                                  {.name = "toe", .parent = 3, .rest = {.translation = {0, 0, 1}, .rotation = quarter}},
                                  {.name = "toe_End", .parent = 4, .rest = {.translation = {0, 0, 0.25}}}},
                                 {.rotations = {{.joint = 3, .times = {0, 0.5}, .values = {quarter, quarter}}}});
  const auto written = write_bvh(scene);
  ASSERT_TRUE(written);
  EXPECT_EQ(
      written->bytes,
      "HIERARCHY\nROOT hip_bone\n{\n\tOFFSET 0 1 0\n\tCHANNELS 3 Xposition Yposition Zposition\n\tJOINT knee\n\t{\n"
      "\t\tOFFSET 0 -0.5 0\n\t\tCHANNELS 3 Zrotation Yrotation Xrotation\n\t\tJOINT toe\n\t\t{\n\t\t\tOFFSET 0 0 1\n"
      "\t\t\tCHANNELS 3 Zrotation Yrotation Xrotation\n\t\t\tEnd Site\n\t\t\t{\n\t\t\t\tOFFSET 0 0 0.25\n\t\t\t}\n"
      "\t\t}\n\t}\n}\nMOTION\nFrames: 2\nFrame Time: 0.5\n0 1 0 0 0 90 0 0 90\n0 1 0 0 0 90 0 0 90\n");
  EXPECT_EQ(warnings_of(written),
            std::vector<std::string>{"folder/out.bvh: 1 joint with '_' for what a name of BVH cannot hold"});
}

TEST(BvhWriter, SeveralRootsAreJoinedUnderOneAndLeavesGetEndSites) {
  const Eigen::Quaterniond one = Eigen::Quaterniond::Identity();
  const Scene scene = made_scene(
      {{.name = "a"}, {.name = "root"}, {.name = "b", .parent = 1}},
      {.rotations = {{.joint = 0, .times = {0}, .values = {one}}, {.joint = 2, .times = {0}, .values = {one}}}});
  const std::string text = text_of(scene);
  EXPECT_EQ(line_of(text, "ROOT"), "ROOT root_");
  const Scene again = scene_of(text);
  ASSERT_EQ(again.skeleton.size(), 6u);
  EXPECT_EQ(again.skeleton[0].rest.translation, Eigen::Vector3d::Zero());
  EXPECT_EQ(again.skeleton[2].name, "a_End");
  EXPECT_EQ(again.skeleton[3].parent, 0u);
  EXPECT_EQ(again.skeleton[5].name, "b_End");
  EXPECT_EQ(line_of(text, "CHANNELS"), "CHANNELS 0");
}

TEST(BvhWriter, AllJointsAreWrittenWhereNoneIsAnimated) {
  const std::string text = text_of(made_scene({{.name = "a"}, {.name = "b", .parent = 0}}, {}));
  EXPECT_NE(text.find("JOINT b"), std::string::npos);
  EXPECT_EQ(frames_of(text).size(), 1u);
}

TEST(BvhWriter, OneClipIsWanted) {
  Scene scene = standing({0});
  for (const char* name : {"walk", "run\n", "sit", "lie", "fly"}) scene.clips.push_back({.name = name});
  EXPECT_EQ(warnings_of(write_bvh(scene))[0],
            "found 6 clips, wanted one of 'made', 'walk', 'run?', 'sit', 'lie', 'fly' (option clip)");
  scene.clips.clear();
  EXPECT_EQ(warnings_of(write_bvh(scene))[0], "found no clip, wanted one");
}

TEST(BvhWriter, ScalesAndTheStartAreDroppedWithAWarning) {
  Scene scene = standing({1.5, 2.0});
  scene.skeleton = Skeleton::make({{.name = "a", .rest = {.scale = {2, 1, 1}}}, {.name = "b", .parent = 0}}).value();
  scene.clips[0].scales.push_back({.joint = 1, .times = {0.0}, .values = {{1, 1, 1.5}}});
  EXPECT_EQ(warnings_of(write_bvh(scene)),
            (std::vector<std::string>{"folder/out.bvh: 2 joints with a scale, which BVH does not hold",
                                      "folder/out.bvh: the clip starts at 1.5 s, its frames at 0 s"}));
}

TEST(BvhWriter, TheFrameTimeIsTheShortestThatReproducesRoundedTimes) {
  const auto frame_time = [](const std::vector<int>& frames, double step) {
    std::vector<double> times;
    for (const int frame : frames) times.push_back(static_cast<double>(static_cast<float>(frame * step)));
    const std::string text = text_of(standing(times));
    return line_of(text, "Frames") + ", " + line_of(text, "Frame Time");
  };
  std::vector<int> all(2752);
  for (int k = 0; k < 2752; ++k) all[static_cast<std::size_t>(k)] = k;
  EXPECT_EQ(frame_time(all, 0.0083333), "Frames: 2752, Frame Time: 0.0083333");
  EXPECT_EQ(frame_time({0, 2, 5, 1000, 2751}, 0.0083333), "Frames: 2752, Frame Time: 0.0083333");
  EXPECT_EQ(frame_time({0, 1, 2, 3}, 0.1), "Frames: 4, Frame Time: 0.1");
  EXPECT_EQ(frame_time({0, 4, 6, 2000}, 0.04), "Frames: 1001, Frame Time: 0.08");
  EXPECT_EQ(frame_time({0}, 0.04), "Frames: 1, Frame Time: 0.0333333");
}

TEST(BvhWriter, TheSourceSaysWhichFrameTimeIsMeant) {
  Scene scene = scene_of(one_joint("CHANNELS 1 Xrotation", "0\n1\n", "Frames: 2\n"));
  EXPECT_EQ(line_of(text_of(scene), "Frame Time"), "Frame Time: 0.0083333");
  scene.clips[0].rotations[0].times = {0.0, 0.25};
  EXPECT_EQ(line_of(text_of(scene), "Frame Time"), "Frame Time: 0.25");
}

TEST(BvhWriter, UnevenKeysNeedARate) {
  const Scene scene =
      turning({0, 0.1, 0.37341}, {turn_about(0, Eigen::Vector3d::UnitX()), turn_about(1, Eigen::Vector3d::UnitX()),
                                  turn_about(2, Eigen::Vector3d::UnitX())});
  const auto refused = write_bvh(scene);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "found keys at uneven times, wanted even key times or a `rate`");
  EXPECT_EQ(refused.error().remedy, "rate");
  const std::string text = text_of(scene, {.rate = 20.0});
  EXPECT_EQ(line_of(text, "Frame Time"), "Frame Time: 0.05");
  const auto frames = frames_of(text);
  ASSERT_EQ(frames.size(), 8u);
  EXPECT_NEAR(frames[1][5], 0.5 * 180 / pi, 1e-12);
  EXPECT_NEAR(frames[7][5], (1 + 0.25 / 0.27341) * 180 / pi, 1e-12);
  for (const double rate : {0.0, -1.0, std::nan(""), 3e8, 1e300}) {
    const auto error = write_bvh(scene, {.rate = rate});
    ASSERT_FALSE(error);
    EXPECT_EQ(error.error().option, "rate");
  }
}

TEST(BvhWriter, AStepThatIsRoundedBeginsInItsFrame) {
  const double third = static_cast<double>(1.0f / 3.0f);  // above 1/3
  ASSERT_GT(third, 1.0 / 3.0);
  Scene scene =
      turning({0, third, 2.0}, {turn_about(0, Eigen::Vector3d::UnitX()), turn_about(1, Eigen::Vector3d::UnitX()),
                                turn_about(0, Eigen::Vector3d::UnitX())});
  scene.clips[0].rotations[0].interpolation = ChannelInterpolation::step;
  const auto frames = frames_of(text_of(scene, {.rate = 3.0}));
  ASSERT_EQ(frames.size(), 7u);
  EXPECT_NEAR(frames[1][5], 180 / pi, 1e-12);
  EXPECT_NEAR(frames[6][5], 0, 1e-12);
}

class CmuRoundTrip : public ::testing::Test {
 protected:
  const std::string path = testing_support::beside_project("data/mocap/cmu_01_01_fairmotion.bvh");
  void SetUp() override {
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  }
};

TEST_F(CmuRoundTrip, KeepsHierarchyAndAngles) {
  const std::string before = bytes_of_file(path).value(), after = text_of(scene_of(before));
  EXPECT_EQ(hierarchy_of(after), hierarchy_of(before));
  EXPECT_EQ(frames_of(after), frames_of(before));
}

double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

TEST_F(CmuRoundTrip, KeepsTheFrameTimeAndTheMotionThroughFloats) {
  const Scene scene = scene_of(bytes_of_file(path).value());
  Scene floats{.skeleton = scene.skeleton, .clips = scene.clips};
  const auto round_times = [](auto& channels) {
    for (auto& channel : channels)
      for (double& time : channel.times) time = rounded(time);
  };
  round_times(floats.clips[0].rotations);
  round_times(floats.clips[0].translations);
  for (RotationChannel& channel : floats.clips[0].rotations)
    for (Eigen::Quaterniond& q : channel.values) q = q.cast<float>().cast<double>();
  const std::string text = text_of(floats);
  EXPECT_EQ(line_of(text, "Frame Time"), "Frame Time: 0.0083333");
  const Scene again = scene_of(text);
  ASSERT_EQ(again.skeleton.size(), scene.skeleton.size());
  double worst = 0.0;
  for (std::size_t c = 0; c < scene.clips[0].rotations.size(); ++c) {
    const auto &found = again.clips[0].rotations[c], &wanted = scene.clips[0].rotations[c];
    ASSERT_EQ(found.times, wanted.times);
    EXPECT_EQ(again.skeleton[found.joint].name, scene.skeleton[wanted.joint].name);
    for (std::size_t k = 0; k < found.size(); ++k)
      worst = std::max(worst, angular_distance(found.values[k], wanted.values[k]));
  }
  EXPECT_LT(worst, 3e-7);
}

}}  // namespace orispline::scenes
