// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/knots.hpp>

#include <gtest/gtest.h>

#include <orispline/math/jet.hpp>

namespace orispline { namespace {

TEST(Knots, FindTheSegmentOfATime) {
  const Knots knots({0.0, 1.0, 3.0, 3.5});
  EXPECT_EQ(knots.segments(), 3u);
  EXPECT_EQ(knots.segment_at(0.5), 0u);
  EXPECT_EQ(knots.segment_at(2.9), 1u);
  EXPECT_EQ(knots.segment_at(3.2), 2u);
}

TEST(Knots, TakeTheRightHandSegmentAtAnInnerKnotAndTheLeftOnRequest) {
  const Knots knots({0.0, 1.0, 3.0, 3.5});
  EXPECT_EQ(knots.segment_at(1.0), 1u);
  EXPECT_EQ(knots.segment_at(1.0, Side::left), 0u);
  EXPECT_EQ(knots.segment_at(3.0), 2u);
  EXPECT_EQ(knots.segment_at(3.0, Side::left), 1u);
}

TEST(Knots, TakeTheOnlySegmentAtAnEndWhateverTheSide) {
  const Knots knots({0.0, 1.0, 3.0, 3.5});
  for (const Side side : {Side::left, Side::right}) {
    EXPECT_EQ(knots.segment_at(0.0, side), 0u);
    EXPECT_EQ(knots.segment_at(3.5, side), 2u);
    EXPECT_EQ(knots.segment_at(-9.0, side), 0u);
    EXPECT_EQ(knots.segment_at(9.0, side), 2u);
  }
}

TEST(Knots, OfOneOrTwoTimesHaveOneSegment) {
  EXPECT_EQ(Knots({1.0}).segment_at(5.0), 0u);
  EXPECT_EQ(Knots({1.0, 2.0}).segment_at(2.0, Side::left), 0u);
}

TEST(KnotSpan, KnowsItsStepsAndMirrorsThemAtTheEnds) {
  const Knots knots({0.0, 1.0, 3.0, 3.5});
  EXPECT_EQ(knots.span(1).previous_step(), 1.0);
  EXPECT_EQ(knots.span(1).step(), 2.0);
  EXPECT_EQ(knots.span(1).next_step(), 0.5);
  EXPECT_EQ(knots.span(0).previous_step(), 1.0);
  EXPECT_EQ(knots.span(2).next_step(), 0.5);
}

TEST(KnotSpan, NormalisesExactlyAtItsEndsAndScalesTheRate) {
  const Knots knots({0.1, 0.4, 0.7});
  EXPECT_EQ(knots.span(1).normalised(0.4), 0.0);
  EXPECT_EQ(knots.span(1).normalised(0.7), 1.0);
  const auto u = knots.span(0).normalised(Jet<double, 2>::variable(0.25));
  EXPECT_DOUBLE_EQ(u.c[1], 1.0 / (0.4 - 0.1));
  EXPECT_EQ(u.c[2], 0.0);
}

}}  // namespace orispline
