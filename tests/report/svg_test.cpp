// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/svg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/counted.hpp>
#include <support/not_finite.hpp>

namespace orispline::report { namespace {

using testing_support::count_of;
using testing_support::nan;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Drawing, IsAWhitePageOfItsSize) {
  EXPECT_EQ(Drawing(30, 20).document(),
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 30 20\" width=\"30\" height=\"20\" "
            "font-family=\"sans-serif\" stroke-linejoin=\"round\">\n"
            "<rect width=\"30\" height=\"20\" fill=\"white\"/>\n</svg>\n");
}

TEST(Drawing, DrawsALineThroughItsPoints) {
  Drawing drawing(30, 20);
  drawing.line(std::array{Point{1, 2}, Point{3.25, 4}}, {color::blue, 2.0, "3 1"});
  EXPECT_EQ(count_of("<polyline points=\"1.0,2.0 3.2,4.0\" fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\" "
                     "stroke-dasharray=\"3 1\"/>\n",
                     drawing.document()),
            1U);
}

TEST(Drawing, BreaksALineWhereAPlaceIsNotFinite) {
  Drawing drawing(30, 20);
  drawing.line(std::array{Point{nan, 0}, Point{1, 1}, Point{2, 2}, Point{3, infinity}, Point{4, 4}, Point{nan, nan},
                          Point{5, 5}, Point{6, 6}, Point{7, 7}});
  EXPECT_EQ(count_of("<polyline", drawing.document()), 2U);  // the lone point 4 is no line
  EXPECT_EQ(count_of("points=\"1.0,1.0 2.0,2.0\"", drawing.document()), 1U);
  EXPECT_EQ(count_of("points=\"5.0,5.0 6.0,6.0 7.0,7.0\"", drawing.document()), 1U);
}

/// How far a line of points [px] is from other points, at most; the point between them is on the segment that is
/// nearest.
double largest_distance(std::span<const Point> line, std::span<const Point> points) {
  double largest = 0.0;
  for (const Point p : points) {
    double nearest = infinity;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Point a = line[i], d{line[i + 1].x - a.x, line[i + 1].y - a.y};
      const double length = d.x * d.x + d.y * d.y;
      const double share = length == 0.0 ? 0.0 : std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length, 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(a.x + share * d.x - p.x, a.y + share * d.y - p.y));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

std::vector<Point> drawn_points(const std::string& document) {
  std::vector<Point> points;
  std::istringstream list(document.substr(document.find("points=\"") + 8));
  for (Point p{}; list >> p.x && list.get() == ',' && list >> p.y;) points.push_back(p);
  return points;
}

TEST(Drawing, DrawsManyPointsByThoseWithoutWhichTheLineWouldLookOtherwise) {
  constexpr int many = 6000;
  constexpr auto wave = [](double s) { return Point{600.0 * s, 60.0 + 50.0 * std::sin(20.0 * s)}; };
  constexpr auto knot = [](double s) {
    return Point{100.0 + 90.0 * std::cos(17.0 * s), 100.0 + 90.0 * std::sin(11.0 * s)};
  };
  constexpr auto saw = [](double s) { return Point{200.0 * s, 90.0 * std::abs(std::remainder(40.0 * s, 2.0))}; };
  constexpr auto there_and_back = [](double s) { return Point{50.0, 400.0 * std::abs(0.5 - s)}; };
  constexpr auto trembling = [](double s) { return Point{600.0 * s, 30.0 + 0.04 * std::sin(1e5 * s)}; };
  for (Point (*const curve)(double) : {+wave, +knot, +saw, +there_and_back, +trembling}) {
    std::vector<Point> points;
    for (int k = 0; k <= many; ++k) points.push_back(curve(static_cast<double>(k) / many));
    Drawing drawing(600, 200);
    drawing.line(points);
    const auto drawn = drawn_points(drawing.document());
    EXPECT_LT(drawn.size(), 400U);
    EXPECT_LT(largest_distance(drawn, points), 0.1 + 0.08);  // and what the one digit behind the point rounds
    EXPECT_LT(largest_distance(points, drawn), 0.08);
  }
}

TEST(Drawing, LeavesOutWhatHasNoPlace) {
  Drawing drawing(30, 20);
  drawing.line({});
  drawing.line(std::array{Point{1, 1}});
  drawing.polygon(std::array{Point{1, 1}, Point{2, nan}, Point{3, 3}}, {color::red}, {});
  drawing.circle({infinity, 1}, 2, {color::red}, {});
  drawing.text({1, nan}, "nowhere");
  EXPECT_EQ(drawing.document(), Drawing(30, 20).document());
}

TEST(Drawing, FillsPolygonsAndCircles) {
  Drawing drawing(30, 20);
  drawing.polygon(std::array{Point{1, 1}, Point{2, 1}, Point{2, 3}}, {color::red, 0.5}, {color::ink, 1.0});
  drawing.circle({4, 5}, 2.5, {color::white}, {color::ink, 1.0});
  EXPECT_EQ(count_of("<polygon points=\"1.0,1.0 2.0,1.0 2.0,3.0\" fill=\"#d55e00\" fill-opacity=\"0.5\" "
                     "stroke=\"#333333\" stroke-width=\"1\"/>\n"
                     "<circle cx=\"4.0\" cy=\"5.0\" r=\"2.5\" fill=\"white\" stroke=\"#333333\" stroke-width=\"1\"/>\n",
                     drawing.document()),
            1U);
}

TEST(Drawing, WritesWordsThatXmlWouldMisunderstand) {
  Drawing drawing(30, 20);
  drawing.text({1, 2}, "a < b & \"c\" > |ω|", {Anchor::end, color::green, 14});
  EXPECT_EQ(count_of("<text x=\"1.0\" y=\"2.0\" text-anchor=\"end\" fill=\"#009e73\" font-size=\"14\">"
                     "a &lt; b &amp; &quot;c&quot; &gt; |ω|</text>\n",
                     drawing.document()),
            1U);
}

}}  // namespace orispline::report
