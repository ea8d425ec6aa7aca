// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <orispline/math/so3.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "scenes/bvh_file.hpp"
#include "support/places.hpp"

namespace orispline::scenes { namespace {

using test::one_joint;
using test::read_bvh;
using test::scene_of;

constexpr std::string_view small_file =
    "\xEF\xBB\xBFhierarchy\r\n"
    "Root Left Hip\r\n"
    "{\r\n"
    "\tCHANNELS 6 Zrotation Yposition XROTATION Xposition Yrotation Zposition\r\n"
    "\toffset\t1.50 -2 3e0\r\n"
    "\tJOINT knee {\r\n"
    "\t\tOFFSET 0 -4 0\r\n"
    "\t\tCHANNELS 1 Xrotation\r\n"
    "\t\tJOINT toe { OFFSET 0 0 1 CHANNELS 0 End Site { OFFSET 0 0 .5 } End Site of the toe\r\n"
    "\t\t{ OFFSET 0 0 .25 } }\r\n"
    "\t}\r\n"
    "\tJOINT tail\r\n"
    "\t{\r\n"
    "\t\tOFFSET 0 1 0\r\n"
    "\t\tCHANNELS 2 Yposition Zrotation\r\n"
    "\t}\r\n"
    "}\r\n"
    "MOTION\r\n"
    "FRAMES:\t2\r\n"
    "frame time:\t.0083333\r\n"
    "90 11 0 10 0 12 -90 7 180\r\n"
    "90 1 90 2 0 3 0 8 0\r\n";

TEST(Bvh, ReadsJointsInTheOrderOfTheFileWithEndSites) {
  const Scene scene = scene_of(small_file);
  ASSERT_TRUE(scene.warnings.empty()) << describe(scene.warnings[0]);
  const std::vector<std::pair<std::string, std::size_t>> wanted{{"Left Hip", no_parent}, {"knee", 0},     {"toe", 1},
                                                                {"toe_End", 2},          {"toe_End2", 2}, {"tail", 0}};
  ASSERT_EQ(scene.skeleton.size(), wanted.size());
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    EXPECT_EQ(scene.skeleton[j].name, wanted[j].first);
    EXPECT_EQ(scene.skeleton[j].parent, wanted[j].second);
  }
  EXPECT_EQ(scene.skeleton[0].rest.translation, Eigen::Vector3d(1.5, -2, 3));
  EXPECT_EQ(scene.skeleton[4].rest.translation, Eigen::Vector3d(0, 0, .25));
}

TEST(Bvh, HasOneLinearClipThatIsNamedByTheFile) {
  const Scene scene = scene_of(small_file);
  ASSERT_EQ(scene.clips.size(), 1u);
  const Clip& clip = scene.clips[0];
  EXPECT_EQ(clip.name, "walk");
  EXPECT_TRUE(check_clip(scene.skeleton, clip));
  ASSERT_EQ(clip.rotations.size(), 3u);
  ASSERT_EQ(clip.translations.size(), 2u);
  EXPECT_EQ(clip.rotations[2].joint, 5u);
  EXPECT_EQ(clip.translations[1].joint, 5u);
  EXPECT_EQ(clip.rotations[0].interpolation, ChannelInterpolation::linear);
  EXPECT_EQ(clip.rotations[0].times, (std::vector{0.0, 0.0083333}));
}

TEST(Bvh, TurnsAboutTheAxesOfTheBodyInTheOrderOfTheChannels) {
  const Scene scene = scene_of(small_file);
  const Clip& clip = scene.clips[0];
  const auto turned = [&](std::size_t channel, std::size_t key, const Eigen::Vector3d& v) {
    return Eigen::Vector3d(clip.rotations[channel].values[key] * v);
  };
  // 90° about z: x goes to y. Then 90° about the new x: z goes to what was -y, which z made x.
  EXPECT_LT((turned(0, 0, {1, 0, 0}) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((turned(0, 1, {0, 0, 1}) - Eigen::Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((turned(0, 1, {0, 1, 0}) - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((turned(1, 0, {0, 1, 0}) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-15);
  EXPECT_LT((turned(2, 0, {1, 0, 0}) - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-15);
}

TEST(Bvh, PositionChannelsReplaceTheCoordinatesOfTheOffset) {
  const Clip clip = scene_of(small_file).clips[0];
  EXPECT_EQ(clip.translations[0].values[0], Eigen::Vector3d(10, 11, 12));
  EXPECT_EQ(clip.translations[0].values[1], Eigen::Vector3d(2, 1, 3));
  EXPECT_EQ(clip.translations[1].values[0], Eigen::Vector3d(0, 7, 0));
}

TEST(Bvh, TimesAreTheDecimalProductToTheNearestDouble) {
  std::string frames;
  for (int k = 0; k < 1000; ++k) frames += "0\n";
  const Scene scene = scene_of(one_joint("CHANNELS 1 Xrotation", frames, "Frames: 1000\n"));
  const std::vector<double>& times = scene.clips[0].rotations[0].times;
  EXPECT_EQ(times[3], 0.0249999);
  EXPECT_EQ(times[7], 0.0583331);
  EXPECT_EQ(times[999], 8.3249667);
}

TEST(Bvh, ReadsTheStatedFramesOfMoreAndSaysSo) {
  const Scene scene =
      scene_of(one_joint("CHANNELS 2 Xrotation Zrotation", "1 2\n3 4\n5 6\n7 8\n9 10\n", "Frames: 2\n"));
  EXPECT_EQ(scene.clips[0].rotations[0].size(), 2u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(describe(scene.warnings[0]), "folder/walk.bvh:12: found 5 frames, read the 2 that the file states");
  EXPECT_EQ(scene.warnings[0].code, "frames_left_out");
}

TEST(Bvh, SalvagesTheWholeFramesOfAFileThatWasCutOff) {
  const std::string_view channels = "CHANNELS 3 Zrotation Xrotation Yrotation";
  const auto read = [&](std::string_view frames, std::string_view head, bool salvage) {
    return bvh_format.read(one_joint(channels, frames, head), "folder/walk.bvh", {.salvage = salvage});
  };
  const auto cut_off = {
      "1 2 3\n4 5 6\n",        "1 2 3\n4 5 6\n7 8",   "1 2 3\n4 5 6\n7 8\n",        "1 2 3\n4 5 6\n7 8 -",
      "1 2 3\n4 5 6\n7 8 1e-", "1 2 3\n4 5 6\n7 8 9", "1 2 3\r\n4 5 6\r\n7\r\n\x1A"};
  for (const std::string_view frames : cut_off) {
    const auto refused = read(frames, "Frames: 4\n", false);
    ASSERT_FALSE(refused) << frames;
    EXPECT_EQ(refused.error().remedy, "salvage") << frames;
    EXPECT_NE(refused.error().message.find("found 2 whole frames, wanted 4, the number in line 8"), std::string::npos)
        << refused.error().message;
    const auto scene = read(frames, "Frames: 4\n", true);
    ASSERT_TRUE(scene) << frames << describe(scene.error());
    EXPECT_EQ(scene->clips[0].rotations[0].size(), 2u) << frames;
    EXPECT_EQ(scene->clips[0].rotations[0].times, (std::vector<double>{0, 0.0083333})) << frames;
    ASSERT_EQ(scene->warnings.size(), 1u) << frames;
    EXPECT_EQ(scene->warnings[0].code, "frames_missing");
    EXPECT_EQ(scene->warnings[0].message, "found 2 whole frames of the 4 that the file states, read them");
    const std::string written = text_of(*scene);
    EXPECT_NE(written.find("Frames: 2\n"), std::string::npos) << written;
    EXPECT_EQ(frames_of(written), (std::vector<std::vector<double>>{{1, 2, 3}, {4, 5, 6}})) << frames;
  }
}

TEST(Bvh, SalvagesNothingElse) {
  const std::string_view channels = "CHANNELS 3 Zrotation Xrotation Yrotation";
  const auto read = [&](std::string_view frames) {
    return bvh_format.read(one_joint(channels, frames, "Frames: 3\n"), "folder/walk.bvh", {.salvage = true});
  };
  for (const std::string_view frames : {"1 2 3\n4 5 6\n7 8 9", "1 2 3\n4 5 6\n7 8 9\n"}) {
    const auto whole = read(frames);
    ASSERT_TRUE(whole) << frames;
    EXPECT_EQ(whole->clips[0].rotations[0].size(), 3u) << frames;
    EXPECT_TRUE(whole->warnings.empty()) << frames;
  }
  for (const auto& [frames, fault] : std::vector<std::pair<std::string_view, std::string_view>>{
           {"1 2", "10: found 0 whole frames, wanted 3, the number in line 8"},
           {"", "10: found 0 whole frames, wanted 3, the number in line 8"},
           {"1 2 3\n4 5\n7 8 9\n", "11: found 2 numbers in the line, wanted a frame of 3, one for each channel"},
           {"1 2 3\n4 5 x", "11: found 'x', wanted a number such as -1.5e-3"}}) {
    const auto refused = read(frames);
    ASSERT_FALSE(refused) << frames;
    EXPECT_EQ(describe(refused.error()), "folder/walk.bvh:" + std::string(fault));
  }
}

TEST(Bvh, CtrlZAtTheEndEndsTheFile) {
  const std::string whole = one_joint("CHANNELS 1 Xrotation", "1\n2\n", "Frames: 2\n");
  for (const std::string_view end : {"\x1A", "\x1A\r\n", "\n\x1A\x1A\x1A", " \x1A \x1A\n"}) {
    const Scene scene = scene_of(whole + std::string(end));
    ASSERT_EQ(scene.clips.size(), 1u);
    EXPECT_EQ(scene.clips[0].rotations[0].size(), 2u);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(text_of(scene), text_of(scene_of(whole)));
  }
  EXPECT_EQ(scene_of(whole.substr(0, whole.size() - 1) + "\x1A").clips[0].rotations[0].size(), 2u);
  EXPECT_FALSE(read_bvh(one_joint("CHANNELS 1 Xrotation", "1\n\x1A\n2\n", "Frames: 2\n")));
}

TEST(Bvh, ReadsFramesByLinesWhereAllLinesHaveMoreNumbersThanChannels) {
  for (const std::string_view end : {"\n", "\r\n", "\r", " \t\n\n"}) {
    std::string frames;
    for (const std::string_view frame : {"1 2 0", "3 4 0", "5 6 0"}) frames.append(frame).append(end);
    const Scene scene = scene_of(one_joint("CHANNELS 2 Xposition Zposition", frames, "Frames: 2\n"));
    EXPECT_EQ(scene.clips[0].translations[0].values[1], Eigen::Vector3d(3, 2, 4)) << end;
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_EQ(describe(scene.warnings[0]),
              "folder/walk.bvh:10: found 3 numbers in every frame, read the first 2, one for each channel");
    EXPECT_EQ(scene.warnings[0].code, "numbers_left_out");
    EXPECT_EQ(scene.warnings[1].code, "frames_left_out");
    EXPECT_EQ(scene.warnings[1].numbers[0].second, 3.0);
  }
}

TEST(Bvh, SeveralRootsAreReadAndRepeatedNamesAreNoted) {
  const Scene scene = scene_of(
      "HIERARCHY ROOT a\n{ OFFSET 0 0 0 CHANNELS 1 Xrotation }\nROOT a\n{ OFFSET 0 0 0 CHANNELS 1 Yrotation }\n"
      "MOTION Frames: 1 Frame Time: 1 10 20");
  EXPECT_EQ(scene.skeleton.size(), 2u);
  EXPECT_EQ(scene.skeleton[1].parent, no_parent);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(describe(scene.warnings[0]),
            "folder/walk.bvh:3: found 1 joint with the name of an earlier one, the first being 'a'");
}

TEST(Bvh, NamesThatAreNoUnicodeAreReadAsUnicode) {
  EXPECT_EQ(scene_of("HIERARCHY ROOT \x8d\xb6\xc3\xa4\xed\xa0\x80\n{ OFFSET 0 0 0 CHANNELS 1 Xrotation }\n"
                     "MOTION Frames: 1 Frame Time: 1 10")
                .skeleton[0]
                .name,
            "\xEF\xBF\xBD\xEF\xBF\xBD\xc3\xa4\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
}

struct Refusal {
  std::string text, error;
};

std::string text_of_error(std::string_view text) {
  const auto scene = read_bvh(text);
  return scene ? "none" : describe(scene.error());
}

TEST(Bvh, FilesOfStrangersAreRefusedWithTheLine) {
  const std::string three = "CHANNELS 3 Zrotation Xrotation Yrotation";
  const std::vector<Refusal> refusals{
      {"", "1: found the end of the file, wanted HIERARCHY"},
      {std::string("\x7f"
                   "ELF\0",
                   5),
       "1: found '?ELF?', wanted HIERARCHY"},
      {"HIERARCHY\nMOTION", "2: found 'MOTION', wanted ROOT"},
      {"HIERARCHY\nROOT\n{", "2: found a joint without a name, wanted its name on the line of its keyword"},
      {"HIERARCHY\nROOT a\nOFFSET 0 0 0", "3: found 'OFFSET', wanted '{'"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n",
       "5: found the end of the file, wanted OFFSET, CHANNELS, JOINT, End Site or '}'"},
      {"HIERARCHY\nROOT a\n{\n}", "4: found no OFFSET of the joint 'a', wanted one"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0\n}", "5: found '}', wanted a number such as -1.5e-3"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 nan 0\n}", "4: found 'nan', wanted a finite number"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 1e200 0\n}", "4: found '1e200', wanted a number of at most 1e+100 in size"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nOFFSET 0 0 0\n}", "5: found a second OFFSET of the joint 'a', wanted one"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nEnd Sight\n{", "5: found 'Sight', wanted Site"},
      {"HIERARCHY\nROOT a\n{\nEnd Site\n{\nCHANNELS 0", "6: found 'CHANNELS', wanted OFFSET or '}'"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0 BONE b", "4: found 'BONE', wanted OFFSET, CHANNELS, JOINT, End Site or '}'"},
      {one_joint("CHANNELS 3 Zrotation Xrotation", "0 0 0"), "5: found 2 channels after CHANNELS 3, wanted 3"},
      {one_joint("CHANNELS 3 Zrotation Xrotation Wrotation", ""),
       "5: found 'Wrotation', wanted a channel such as Xposition or Zrotation"},
      {one_joint("CHANNELS three Zrotation", ""), "5: found 'three', wanted a number of channels from 0 to 6"},
      {one_joint("CHANNELS 7 Xrotation Xrotation Xrotation Xrotation Xrotation Xrotation Xrotation", ""),
       "5: found 7 channels, wanted at most 6"},
      {one_joint("CHANNELS 2 Xposition xposition", "0 0"),
       "5: found a second 'xposition' of the joint 'hip', wanted one"},
      {one_joint("CHANNELS 0", ""), "7: found no channels, wanted one at least"},
      {one_joint(three, "0 0 0", "Frames: many\n"), "8: found 'many', wanted a number of frames"},
      {one_joint(three, "0 0 0", "Frames: -1\n"), "8: found '-1', wanted a number of frames"},
      {one_joint(three, "0 0 0", "Frames: 0\n"), "8: found 0 frames, wanted one at least"},
      {one_joint(three, "0 0 0", "Frames: 1e3\n"), "8: found '1e3', wanted a number of frames"},
      {one_joint(three, "0 0 0", "Frames: 99999999999999999999999\n"),
       "8: found '99999999999999999999999', wanted a number of frames"},
      {one_joint(three, "0 0 0\n1 2\n", "Frames: 89478485\n"),
       "12: found 1 whole frame, wanted 89478485, the number in line 8 (option salvage)"},
      {one_joint(three, "0 0 0\n1 2\n", "Frames: 89478486\n"),
       "8: found 89478486 frames of 3 channels, wanted 268435456 numbers at most in all"},
      {one_joint(three, "0 0 0", ""), "8: found 'Frame', wanted Frames:"},
      {one_joint(three, "0 0 0\n1\n2 3\n4 5 6\n", "Frames: 3\n"),
       "11: found 1 number in the line, wanted a frame of 3, one for each channel"},
      {one_joint(three, "0 0 0\n1 2 3 4\n5 6 7\n", "Frames: 3\n"),
       "11: found 4 numbers in the line, wanted a frame of 3, one for each channel"},
      {one_joint(three, "0 0 0 0\n1 2 3 4\n5 6 7\n", "Frames: 3\n"),
       "12: found 3 numbers in the line, wanted a frame of 3, one for each channel, or 4 as in line 10"},
      {one_joint(three, "0 0 0 1 2 3\n4 5 6 7 8 9\n", "Frames: 2\n"),
       "10: found 6 numbers in the line, wanted a frame of 3, one for each channel"},
      {one_joint(three, "0 0 0 x\n"), "10: found 'x', wanted a number such as -1.5e-3"},
      {one_joint(three, "0 inf 0"), "10: found 'inf', wanted a finite number"},
      {one_joint(three, "0 1e999 0"), "10: found '1e999', wanted a number below 1.8e308 in size"},
      {one_joint(three, "0 1e10 0"), "10: found '1e10', wanted a number of at most 1e+09 in size"},
      {one_joint(three, "0 1,5 0"), "10: found '1,5', wanted a number such as -1.5e-3"},
      {one_joint(three, "0 0 0\nHIERARCHY\n"), "11: found 'HIERARCHY', wanted a number such as -1.5e-3"},
      {one_joint(three, ""), "10: found 0 whole frames, wanted 1, the number in line 8"},
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\n", "6: found the end of the file, wanted ROOT or MOTION"},
  };
  for (const auto& [text, error] : refusals) EXPECT_EQ(text_of_error(text), "folder/walk.bvh:" + error) << text;
}

TEST(Bvh, FrameTimesAreAboveZero) {
  const auto error = [](std::string_view time) {
    return text_of_error(
        std::string("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\nMOTION\nFrames: 1\nFrame Time: ")
            .append(time)
            .append("\n0\n"));
  };
  EXPECT_EQ(error("0"), "folder/walk.bvh:9: found '0', wanted a frame time above 0");
  EXPECT_EQ(error("-0.1"), "folder/walk.bvh:9: found '-0.1', wanted a frame time above 0");
  EXPECT_EQ(error("nan"), "folder/walk.bvh:9: found 'nan', wanted a number such as -1.5e-3");
  EXPECT_EQ(error("1e999"), "folder/walk.bvh:9: found '1e999', wanted a number between 1e-150 and 1e150 in size");
}

TEST(Bvh, DeepNestingIsRefusedBeforeItCostsAnything) {
  std::string text = "HIERARCHY\n";
  for (int depth = 0; depth < 100000; ++depth) text += depth == 0 ? "ROOT a\n{\n" : "JOINT a\n{\n";
  EXPECT_EQ(text_of_error(text), "folder/walk.bvh:1027: found joints nested deeper than 512, wanted at most that");
}

class CmuFile : public ::testing::Test {
 protected:
  const std::string path = testing_support::beside_project("data/mocap/cmu_01_01_fairmotion.bvh");
  void SetUp() override {
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  }
};

Eigen::Quaterniond turn(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180.0, axis));
}

TEST_F(CmuFile, HasTheProductsOfItsTurns) {
  const auto scene = read_scene(path);
  ASSERT_TRUE(scene) << describe(scene.error());
  const Clip& clip = scene->clips[0];
  ASSERT_EQ(clip.rotations.size(), 31u);
  ASSERT_EQ(clip.rotations[0].size(), 2752u);
  // All joints turn about z, y, x; the root has three positions before its turns.
  const auto bytes = bytes_of_file(path);
  std::istringstream numbers(bytes->substr(bytes->find('\n', bytes->find("Frame Time"))));
  double worst = 0.0;
  for (std::size_t k = 0; k < 2752; ++k) {
    Eigen::Vector3d position;
    numbers >> position[0] >> position[1] >> position[2];
    ASSERT_EQ(clip.translations[0].values[k], position);
    for (std::size_t j = 0; j < 31; ++j) {
      double z = 0, y = 0, x = 0;
      numbers >> z >> y >> x;
      const Eigen::Quaterniond wanted =
          turn(z, Eigen::Vector3d::UnitZ()) * turn(y, Eigen::Vector3d::UnitY()) * turn(x, Eigen::Vector3d::UnitX());
      worst = std::max(worst, angular_distance(clip.rotations[j].values[k], wanted));
    }
  }
  ASSERT_TRUE(numbers);
  EXPECT_LT(worst, 1e-12);
  EXPECT_EQ(clip.rotations[0].times[2751], 22.9249083);
}

}}  // namespace orispline::scenes
