// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/sphere.hpp>

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include <support/counted.hpp>

namespace orispline::report { namespace {

using Eigen::Vector3d;
using testing_support::count_of;

std::string drawn(const SpherePicture& picture) {
  Drawing drawing(200, 200);
  draw(drawing, View(Vector3d::UnitX()), {100, 100}, 80, picture);
  return drawing.document();
}

std::vector<Vector3d> equator(double from, double to) {
  std::vector<Vector3d> path;
  for (int k = 0; k <= 50; ++k) {
    const double angle = std::lerp(from, to, k / 50.0);
    path.push_back({std::cos(angle), std::sin(angle), 0.0});
  }
  return path;
}

TEST(Sphere, DrawsAPathInFrontInFull) {
  const std::string svg = drawn({{{equator(-0.5, 0.5), {color::blue, 2.0}}}});
  EXPECT_EQ(count_of("stroke=\"#0072b2\" stroke-width=\"2\"/>", svg), 1U);
  EXPECT_EQ(count_of("#0072b2", svg), 1U);
  EXPECT_EQ(count_of("r=\"80\"", svg), 1U);
}

TEST(Sphere, DrawsTheFarSidePaleAndDashed) {
  const std::string svg = drawn({{{equator(0.0, 3.0), {color::blue, 2.0}}}});
  EXPECT_EQ(count_of("stroke=\"#0072b2\" stroke-width=\"2\"/>", svg), 1U);
  EXPECT_EQ(count_of("stroke=\"#0072b2\" stroke-width=\"0.9\" stroke-dasharray=\"3 3\"/>", svg), 1U);
}

TEST(Sphere, DotsAreFullInFrontAndHollowBehind) {
  const std::string svg = drawn({{}, {{Vector3d::UnitY(), "side"}, {-Vector3d::UnitX(), "behind", color::red}}});
  EXPECT_EQ(count_of("cx=\"180.0\" cy=\"100.0\" r=\"4\" fill=\"#333333\"", svg), 1U);
  EXPECT_EQ(count_of("cx=\"100.0\" cy=\"100.0\" r=\"4\" fill=\"white\" stroke=\"#d55e00\"", svg), 1U);
  EXPECT_EQ(count_of(">side<", svg) + count_of(">behind<", svg), 2U);
}

/// Where a text stands in a picture: the point that it is anchored at.
Point place_of(const std::string& word, const std::string& svg) {
  const std::size_t start = svg.rfind("<text", svg.find(">" + word + "<"));
  Point place{};
  EXPECT_EQ(std::sscanf(svg.c_str() + start, "<text x=\"%lf\" y=\"%lf\"", &place.x, &place.y), 2);
  return place;
}

TEST(Sphere, ALabelStandsAboveItsDotWhereThereIsRoom) {
  const Point place = place_of("a", drawn({{}, {{Vector3d::UnitX(), "a"}}}));
  EXPECT_DOUBLE_EQ(place.x, 100.0);
  EXPECT_DOUBLE_EQ(place.y, 91.0);
}

TEST(Sphere, ALabelKeepsOffTheLinesTheDotsAndTheOtherLabels) {
  std::vector<Vector3d> upright;
  for (int k = -50; k <= 50; ++k) upright.push_back({std::cos(0.03 * k), 0.0, std::sin(0.03 * k)});
  const std::vector<SphereDot> two{{Vector3d::UnitX(), "1"}, {Vector3d(std::cos(0.1), std::sin(0.1), 0.0), "2"}};
  const std::string svg = drawn({{{upright}}, two});
  const Point one = place_of("1", svg), other = place_of("2", svg);
  EXPECT_GT(std::abs(one.x - 100.0), 9.0);  // the line goes up and down at x = 100 px
  EXPECT_GT(std::hypot(one.x - other.x, one.y - other.y), 9.0);
  for (const Point& place : {one, other})
    for (const double x : {100.0, 100.0 + 80.0 * std::sin(0.1)})
      EXPECT_GT(std::hypot(place.x - x, place.y - 4.0 - 100.0), 9.0);
}

TEST(Sphere, FacesTheMiddleOfDirections) {
  const std::vector<Vector3d> around_y{{0.3, 1.0, 0.0}, {-0.3, 1.0, 0.0}};
  const View view = facing(around_y);
  EXPECT_GT(view.depth(Vector3d::UnitY()), 0.95);
  EXPECT_GT(view.depth(Vector3d::UnitZ()), 0.1);  // a little from above
}

TEST(Sphere, HasAViewWhereThereIsNoMiddle) {
  const std::vector<Vector3d> opposite{Vector3d::UnitX(), -Vector3d::UnitX()};
  for (const std::span<const Vector3d> directions : {std::span<const Vector3d>(opposite), std::span<const Vector3d>()})
    EXPECT_GT(facing(directions).depth(Vector3d::UnitX()), 0.9);
}

}}  // namespace orispline::report
