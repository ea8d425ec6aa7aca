// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/sphere.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <support/counted.hpp>
#include <support/tolerance.hpp>

namespace orispline::report { namespace {

using Eigen::Vector3d;
using testing_support::count_of;

void expect_at(const View& view, const Vector3d& v, double x, double y) {
  const Point p = view.at(v, {100, 50}, 10);
  EXPECT_NEAR(p.x, x, 1e2 * tolerance::exact);
  EXPECT_NEAR(p.y, y, 1e2 * tolerance::exact);
}

TEST(View, FromTheFrontHasYToTheRightAndZUp) {
  const View view(Vector3d(2, 0, 0));
  expect_at(view, Vector3d::UnitX(), 100, 50);
  expect_at(view, Vector3d::UnitY(), 110, 50);
  expect_at(view, Vector3d::UnitZ(), 100, 40);
  EXPECT_DOUBLE_EQ(view.depth(Vector3d(3, 4, 5)), 3.0);
}

TEST(View, KeepsLengthsAcrossTheLineOfSight) {
  for (const Vector3d& eye : {Vector3d(1, 0.12, 0.22), Vector3d(-1, 2, -3), Vector3d(0, 0, 1), Vector3d(0, 0, -2)}) {
    const View view(eye);
    const Vector3d v(0.3, -1.2, 0.7);
    const Point p = view.at(v, {0, 0}, 1);
    EXPECT_NEAR(p.x * p.x + p.y * p.y + view.depth(v) * view.depth(v), v.squaredNorm(), tolerance::algebra);
  }
}

TEST(View, ShowsABodyThatTurnsAsItTurns) {
  const View view(Vector3d(0, 0, 1));
  const auto drawn = [&](const Eigen::Quaterniond& q) {
    Drawing drawing(100, 100);
    draw_body(drawing, view, {50, 50}, 10, q, color::blue);
    return drawing.document();
  };
  const std::string straight = drawn(Eigen::Quaterniond::Identity());
  EXPECT_EQ(count_of("<polygon", straight), 3U);  // two wings and a fin
  EXPECT_EQ(straight, drawn(Eigen::Quaterniond(-1, 0, 0, 0)));
  EXPECT_NE(straight, drawn(exp<double>(Vector3d(0, 0, 1))));
  EXPECT_EQ(count_of("50.0,40.0", straight), 2U);  // the nose of both wings: from above x is up and y to the left
  EXPECT_EQ(count_of("40.0,50.0", drawn(exp<double>(Vector3d(0, 0, std::numbers::pi / 2)))), 2U);
}

TEST(View, PaintsTheNearerFacesLast) {
  Drawing drawing(100, 100);
  draw_body(drawing, View(Vector3d(0, 0, 1)), {50, 50}, 10, Eigen::Quaterniond::Identity(), color::blue);
  const std::string svg = drawing.document();
  EXPECT_GT(svg.find("fill-opacity=\"0.35\""), svg.find("fill-opacity=\"0.85\""));  // the fin is on top
}

TEST(View, ShowsAFaceOfASolidFromOutsideOnly) {
  const std::vector<Face> square{{{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}, 1.0, Sides::outside}};
  const auto faces_from = [&](const Vector3d& eye) {
    Drawing drawing(100, 100);
    draw_body(drawing, View(eye), {50, 50}, 10, Eigen::Quaterniond::Identity(), color::blue, square);
    return count_of("<polygon", drawing.document());
  };
  EXPECT_EQ(faces_from({0.3, 0.2, 1.0}), 1U);
  EXPECT_EQ(faces_from({0.3, 0.2, -1.0}), 0U);
}

}}  // namespace orispline::report
