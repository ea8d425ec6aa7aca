// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/expected.hpp>

#include <gtest/gtest.h>

namespace orispline { namespace {

TEST(Error, IsOneLineWithThePlacesThatAreKnown) {
  EXPECT_EQ(describe({ErrorCode::bad_data, "what", {}}), "what");
  EXPECT_EQ(describe({ErrorCode::bad_data, "what", {.file = "keys.csv"}}), "keys.csv: what");
  EXPECT_EQ(describe({ErrorCode::bad_data, "what", {.file = "keys.csv", .line = 7}}), "keys.csv:7: what");
  EXPECT_EQ(describe({ErrorCode::bad_data, "what", {.file = "-", .line = 7, .column = 3, .key = 2}}),
            "-:7:3: key 2: what");
  EXPECT_EQ(describe({ErrorCode::bad_data, "what", {.key = 0}}), "key 0: what");
  EXPECT_EQ(describe({ErrorCode::bad_argument, "what", {.time_index = 2}}), "time 2: what");
  EXPECT_EQ(describe({ErrorCode::bad_argument, "what", {.curve = 3}}), "curve 3: what");
}

TEST(Error, IsOnePrintableLine) {
  EXPECT_EQ(describe({ErrorCode::bad_data, "found \x1b[2J\u009b2J\x7f", {.file = "a\nb\r.csv", .line = 7}}),
            "a?b?.csv:7: found ?[2J?2J?");
  EXPECT_EQ(describe({ErrorCode::bad_data, "größer \u00a0 – 日本", {}}), "größer \u00a0 – 日本");
  EXPECT_EQ(describe({ErrorCode::bad_data, "cut \xC2", {}}), "cut ?");
}

TEST(Error, TravelsAsTheFailureOfAnExpected) {
  const Expected<int> nothing = failure(ErrorCode::bad_access, "cannot open", {.file = "x"});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::bad_access);
  EXPECT_EQ(describe(nothing.error()), "x: cannot open");
}

}}  // namespace orispline
