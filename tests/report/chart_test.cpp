// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/chart.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <support/counted.hpp>
#include <support/not_finite.hpp>

namespace orispline::report { namespace {

using testing_support::count_of;
using testing_support::nan;

constexpr Box box{100, 10, 200, 50};

std::string drawn(const Chart& chart) {
  Drawing drawing(400, 100);
  draw(drawing, box, chart);
  return drawing.document();
}

std::string curve_through(std::string_view points) { return "<polyline points=\"" + std::string(points) + "\""; }

TEST(Chart, TakesTheRangeOfFiniteValues) {
  const std::vector<double> values{3.0, nan, -1.0, std::numeric_limits<double>::infinity(), 2.0};
  EXPECT_EQ(range_of(values).low, -1.0);
  EXPECT_EQ(range_of(values).high, 3.0);
  EXPECT_EQ(range_of({}).extent(), 1.0);
}

TEST(Chart, WidensARangeByATwentiethAtEitherEnd) {
  EXPECT_DOUBLE_EQ(with_margin({0, 10}).low, -0.5);
  EXPECT_DOUBLE_EQ(with_margin({0, 10}).high, 10.5);
  EXPECT_EQ(with_margin({4, 4}).low, 3.0);
  EXPECT_EQ(with_margin({4, 4}).high, 5.0);
}

TEST(Chart, CutsARangeAtRoundValues) {
  EXPECT_EQ(round_values({0, 4}), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(round_values({-7, 9}), (std::vector<double>{-5, 0, 5}));
  const auto tenths = round_values({-0.2, 1.1});
  ASSERT_EQ(tenths.size(), 7U);
  EXPECT_DOUBLE_EQ(tenths.front(), -0.2);
  EXPECT_EQ(tenths[1], 0.0);
  EXPECT_DOUBLE_EQ(tenths.back(), 1.0);
}

TEST(Chart, CutsEveryRangeIntoAFewParts) {
  for (const double extent : {1e-12, 0.03, 0.9999, 1.0, 2.9, 3.0, 7.0, 14.99, 15.0, 123456.0})
    for (const double low : {0.0, -0.3 * extent, 1.7 * extent}) {
      const std::size_t count = round_values({low, low + extent}).size();
      EXPECT_GE(count, 3U) << low << " and " << extent;
      EXPECT_LE(count, 8U) << low << " and " << extent;
    }
}

TEST(Chart, PutsValuesInTheirPlace) {
  const std::string svg = drawn({.title = "t", .series = {{"a", {0, 1, 2}, {0, 5, 10}}}, .y = Range{0, 10}});
  EXPECT_EQ(count_of(curve_through("100.0,60.0 200.0,35.0 300.0,10.0"), svg), 1U);
}

TEST(Chart, StandsOnZeroWhereNothingIsNegative) {
  const std::string svg = drawn({.title = "t", .series = {{"a", {0, 2}, {10, 20}}}});
  EXPECT_EQ(count_of(curve_through("100.0,36.2 300.0,12.4"), svg), 1U);  // 0 to 21: 20 and a margin
}

TEST(Chart, LeavesOutWhatIsOutsideItsRangeAndBreaksThere) {
  const std::string svg =
      drawn({.title = "t", .series = {{"a", {0, 1, 2, 3, 4}, {1, 2, 99, 2, 1}}}, .y = Range{0, 10}});
  EXPECT_EQ(count_of(curve_through("100.0,55.0 150.0,50.0"), svg), 1U);
  EXPECT_EQ(count_of(curve_through("250.0,50.0 300.0,55.0"), svg), 1U);
}

TEST(Chart, SaysWhereTheMarksAre) {
  const std::string svg =
      drawn({.title = "t", .series = {{"a", {0, 4}, {1, 2}}}, .marks = {{1, "first"}, {3, "second"}}, .x_unit = " s"});
  EXPECT_EQ(count_of(curve_through("150.0,10.0 150.0,60.0"), svg), 1U);
  EXPECT_EQ(count_of(">first<", svg) + count_of(">second<", svg), 2U);
  EXPECT_EQ(count_of(" s<", svg), 0U);
}

TEST(Chart, NumbersTheAxisWithItsUnitWhereThereAreNoMarks) {
  const std::string svg = drawn({.title = "t", .series = {{"a", {0, 4}, {1, 2}}}, .x_unit = " s"});
  for (const char* number : {">0 s<", ">1 s<", ">2 s<", ">3 s<", ">4 s<"}) EXPECT_EQ(count_of(number, svg), 1U);
}

TEST(Chart, OfNothingOrOneValueIsStillAPicture) {
  for (const Chart& chart :
       {Chart{.title = "t", .series = {}}, Chart{.title = "t", .series = {{"a", {}, {}}}},
        Chart{.title = "t", .series = {{"a", {1}, {7}}}}, Chart{.title = "t", .series = {{"a", {1, 2}, {nan, nan}}}},
        Chart{.title = "t", .series = {{"a", {1, 2}, {0, 0}}}}}) {
    const std::string svg = drawn(chart);
    EXPECT_EQ(count_of(">t</text>", svg), 1U);
    EXPECT_EQ(count_of("nan", svg) + count_of("inf", svg), 0U) << svg;
  }
}

TEST(Chart, LegendNamesEveryLabelOnce) {
  Drawing drawing(400, 100);
  draw_legend(drawing, {10, 10},
              std::vector<Series>{{"α = 1", {}, {}, {color::blue}}, {"", {}, {}}, {"α = 1", {}, {}}, {"b", {}, {}}});
  const std::string svg = drawing.document();
  EXPECT_EQ(count_of("α = 1", svg), 1U);
  EXPECT_EQ(count_of("<text", svg), 2U);
  EXPECT_EQ(count_of("<text x=\"124.0\"", svg), 1U);  // 10 + 50 + 7.2 for each of 5 characters + 28
}

}}  // namespace orispline::report
