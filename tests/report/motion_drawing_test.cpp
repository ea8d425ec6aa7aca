// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/motion_drawing.hpp>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/report/sphere.hpp>
#include <support/counted.hpp>

namespace orispline::report { namespace {

using testing_support::count_of;

/// A turn about z at a steady rate [rad/s], for 2 s.
PageMethod turning(const std::string& name, double rate) {
  PageMethod method{.name = name};
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.1 * k;
    method.samples.path.times.push_back(t);
    method.samples.path.orientations.push_back(exp<double>({0.0, 0.0, rate * t}));
    method.samples.angular_velocities.push_back({0.0, 0.0, rate});
    method.samples.angular_accelerations.push_back(Eigen::Vector3d::Zero());
    method.samples.angular_jerks.push_back(Eigen::Vector3d::Zero());
  }
  return method;
}

PageKeys keys_of(std::size_t count) {
  PageKeys keys;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2.0 * static_cast<double>(k) / static_cast<double>(count - 1);
    keys.path.times.push_back(t);
    keys.path.orientations.push_back(exp<double>({0.0, 0.0, t}));
  }
  return keys;
}

TEST(MotionDrawing, HasFourChartsWithTheKeysMarkedAndTheTimesBelow) {
  const std::string svg =
      motion_drawing({.title = "a & b", .keys = keys_of(3), .methods = {turning("m", 1.0)}}).document();
  EXPECT_EQ(count_of("stroke=\"#bbbbbb\" stroke-width=\"1\" stroke-dasharray=\"3 3\"", svg), 4U * 3U);
  EXPECT_EQ(count_of(">1 s<", svg), 4U);
  EXPECT_EQ(count_of(">a &amp; b<", svg), 1U);
  for (const char* title : {"angle from the start [deg]", "|ω| [rad/s]", "|α| [rad/s²]", "jerk [rad/s³]", "axis x on"})
    EXPECT_EQ(count_of(title, svg), 1U) << title;
}

TEST(MotionDrawing, DrawsASteadyRateAsALevelLineAtItsValue) {
  const std::string svg = motion_drawing({.title = "", .keys = keys_of(2), .methods = {turning("m", 1.0)}}).document();
  // The range of |ω| is [0, 1.05], the chart 130 px high with its top at 270 px: 1 rad/s is 6.2 px below the top.
  EXPECT_EQ(count_of("points=\"70.0,276.2 103.0,276.2 ", svg), 1U);
  // After 1 s the angle is 57.3° of a range up to 1.05 · 114.6°: 130 · (1 - 1/2.1) px below 85 px.
  EXPECT_EQ(count_of(" 400.0,153.1 ", svg), 1U);
}

TEST(MotionDrawing, GivesEachMethodAColourAndPutsTheFirstOnTop) {
  const MotionPicture picture{.title = "", .keys = keys_of(2), .methods = {turning("one", 1.0), turning("two", 0.5)}};
  const std::string svg = motion_drawing(picture).document();
  EXPECT_EQ(count_of("fill=\"#0072b2\" font-size=\"12\">one<", svg), 1U);
  EXPECT_EQ(count_of("fill=\"#d55e00\" font-size=\"12\">two<", svg), 1U);
  EXPECT_EQ(count_of("stroke=\"#0072b2\" stroke-width=\"2\"/>", svg),
            count_of("stroke=\"#d55e00\" stroke-width=\"1.4\"/>", svg) + 1);
  EXPECT_GT(svg.rfind("stroke=\"#0072b2\" stroke-width=\"2\"/>"), svg.rfind("stroke=\"#d55e00\""));
}

TEST(MotionDrawing, PutsNamesWithoutRoomBelowEachOther) {
  std::string tensions = "quintic:tension=1";
  for (int i = 0; i < 90; ++i) tensions += ",0.1";
  const MotionPicture picture{
      .title = "", .keys = keys_of(2), .methods = {turning("one", 1.0), turning(tensions, 0.5), turning("three", 0.5)}};
  const std::string svg = motion_drawing(picture).document();
  EXPECT_EQ(count_of("<text x=\"98.0\" y=\"54.0\" text-anchor=\"start\" fill=\"#0072b2\" font-size=\"12\">one<", svg),
            1U);
  EXPECT_EQ(
      count_of("<text x=\"98.0\" y=\"72.0\" text-anchor=\"start\" fill=\"#d55e00\" font-size=\"12\">quintic:", svg),
      1U);
  EXPECT_EQ(count_of("<text x=\"98.0\" y=\"", svg), 5U);  // 377 characters in three lines, with commas at their ends
  EXPECT_EQ(count_of(",<", svg), 2U);
  EXPECT_EQ(
      count_of("<text x=\"98.0\" y=\"126.0\" text-anchor=\"start\" fill=\"#009e73\" font-size=\"12\">three<", svg), 1U);
  EXPECT_EQ(count_of("height=\"897\"", svg), 2U);  // four lines more than 825
}

TEST(MotionDrawing, LeavesOutTheMarksOfVeryManyKeys) {
  const std::string svg =
      motion_drawing({.title = "", .keys = keys_of(201), .methods = {turning("m", 1.0)}}).document();
  EXPECT_EQ(count_of("stroke=\"#bbbbbb\" stroke-width=\"1\" stroke-dasharray=\"3 3\"", svg), 0U);
  EXPECT_EQ(count_of("r=\"4\"", svg), 0U);
}

TEST(MotionDrawing, DrawsNoGhostsUnlessAskedTo) {
  const std::string svg = motion_drawing({.title = "", .keys = keys_of(3), .methods = {turning("m", 1.0)}}).document();
  EXPECT_EQ(count_of("<polygon", svg), 0U);
  EXPECT_EQ(count_of("height=\"825\"", svg), 2U);  // of the file and of its white ground
}

TEST(MotionDrawing, DrawsARowOfGhostsPerMethodWhereTheirTimesAre) {
  MotionPicture picture{.title = "", .keys = keys_of(3), .methods = {turning("one", 1.0), turning("two", 2.0)}};
  picture.ghosts = 5;
  const std::string svg = motion_drawing(picture).document();
  EXPECT_EQ(count_of("<polygon", svg), 2U * 5U * 3U);  // an aircraft has three faces
  EXPECT_EQ(count_of("the body at 5 even times", svg), 1U);
  // The body at 1 s, in the middle of 660 px from 70 px on, of both methods.
  const View view({1.0, -0.9, 0.8});
  for (const auto& [turn, y] : {std::pair{1.0, 864.4}, std::pair{2.0, 923.2}}) {
    Drawing body(1180, 900);
    draw_body(body, view, {400.0, y}, 24.0, exp<double>({0.0, 0.0, turn}), color::blue);
    const std::string alone = body.document();
    const std::size_t from = alone.find("points=\""), to = alone.find('"', from + 8);
    EXPECT_EQ(count_of(alone.substr(from, to - from), svg), 1U) << turn;
  }
}

TEST(MotionDrawing, SaysWhatItsChartsShow) {
  const PageMethod method = turning("m", 0.5);
  std::vector<std::string_view> words;
  for (const DrawnQuantity& quantity : drawn_quantities()) {
    words.push_back(quantity.word);
    EXPECT_EQ(quantity.values(method.samples).size(), method.samples.path.times.size()) << quantity.title;
  }
  EXPECT_EQ(words, (std::vector<std::string_view>{"angle", "rate", "acceleration", "jerk"}));
  EXPECT_NEAR(drawn_quantities()[0].values(method.samples).back(), 57.29577951308232, 1e-12);  // [deg] of 1 rad
  EXPECT_DOUBLE_EQ(drawn_quantities()[1].values(method.samples)[3], 0.5);
}

}}  // namespace orispline::report
