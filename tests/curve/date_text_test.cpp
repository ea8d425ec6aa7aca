// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/date_text.hpp>

#include <gtest/gtest.h>

#include <orispline/curve/track.hpp>

namespace orispline { namespace {

std::string date_of(const char* seconds) { return date_text(Decimal::parse(seconds).value()); }

TEST(DateText, IsTheDateInUtcWithAllDecimals) {
  EXPECT_EQ(date_of("0"), "1970-01-01T00:00:00");
  EXPECT_EQ(date_of("1772359200.37"), "2026-03-01T10:00:00.37");
  EXPECT_EQ(date_of("951782400.000000001"), "2000-02-29T00:00:00.000000001");
  EXPECT_EQ(date_of("-0.25"), "1969-12-31T23:59:59.75");
  EXPECT_EQ(date_of("-11676096000"), "1600-01-01T00:00:00");
  EXPECT_EQ(date_of("253402300799.5"), "9999-12-31T23:59:59.5");
}

TEST(DateText, IsSecondsWhereTheYearHasMoreDigits) {
  EXPECT_EQ(date_of("253402300800"), "253402300800 s");
  EXPECT_EQ(date_of("-1e13"), "-10000000000000 s");
  EXPECT_EQ(date_of("1e140").back(), 's');
}

TEST(DateText, IsHowATrackWithDatesTellsItsTimes) {
  Track track;
  const Decimal from = Decimal::parse("10").value(), to = Decimal::parse("12.5").value();
  EXPECT_EQ(track.time_text(to), "12.5 s");
  EXPECT_EQ(track.span_text(from, to), "10 to 12.5 s");
  track.is_dated = true;
  EXPECT_EQ(track.time_text(to), "1970-01-01T00:00:12.5");
  EXPECT_EQ(track.span_text(from, to), "1970-01-01T00:00:10 to 1970-01-01T00:00:12.5");
}

}}  // namespace orispline
