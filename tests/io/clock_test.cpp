// SPDX-License-Identifier: Apache-2.0
// Times that are no numbers of seconds: fractions, frames, dates of ISO 8601.
#include <orispline/io/clock.hpp>

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>
#include <orispline/io/times_file.hpp>

#include "io/exact_number.hpp"
#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::decimal;
using test::text_of;
using test::TextFile;

Fraction fraction(std::string_view text) { return Fraction::parse(text).value(); }
std::string iso(std::string_view text) {
  const auto time = parse_iso_time(text);
  return time ? time->to_string() : time.error().message;
}

TEST(Decimal, DividesExactlyWhereItCan) {
  const auto quotient = [](const char* a, const char* b) { return decimal(a).divided_by(decimal(b)); };
  EXPECT_EQ(quotient("24", "24").value.to_string(), "1");
  EXPECT_EQ(quotient("-1.5", "0.25").value.to_string(), "-6");
  EXPECT_EQ(quotient("1", "8").value.to_string(), "0.125");
  EXPECT_EQ(quotient("0", "7").value.to_string(), "0");
  EXPECT_TRUE(quotient("1e30", "1.024e-10").is_exact);
  EXPECT_EQ(quotient("1", "3").value.to_string(), "0." + std::string(37, '3'));
  EXPECT_EQ(quotient("2", "3").value.to_string(), "0." + std::string(36, '6') + "7");
  EXPECT_FALSE(quotient("2", "3").is_exact);
  EXPECT_EQ(quotient("1", "1234567890123456789012345678901234567").value.rounded(39).to_string(),
            "0.00000000000000000000000000000000000081");
}

TEST(Decimal, RoundsToSoManyDecimals) {
  EXPECT_EQ(decimal("0.04166666").rounded(4).to_string(), "0.0417");
  EXPECT_EQ(decimal("-0.00005").rounded(4).to_string(), "-0.0001");
  EXPECT_EQ(decimal("1.5").rounded(4).to_string(), "1.5");
  EXPECT_EQ(decimal("1.5").rounded().to_string(), "2");
}

TEST(Fraction, IsReadAsItIsWritten) {
  for (const auto& [text, same] : {std::pair("24", "24"), std::pair("23.976", "23.976"), std::pair("1/24", "1/24"),
                                   std::pair("30000/1001", "30000/1001"), std::pair("1/8", "0.125"),
                                   std::pair("1/-3", "-1/3"), std::pair("2/3", "2/3")})
    EXPECT_EQ(fraction(text).to_string(), same);
  for (const char* text : {"", "/", "1/", "/2", "1/0", "1/2/3", "a/b", "1 / 2", "1e100/1e-100", "1e-100/1e100"})
    EXPECT_EQ(Fraction::parse(text).error().message,
              "found '" + std::string(text) + "', wanted a number such as 25, or a fraction such as 30000/1001");
}

TEST(Fraction, MakesTimesThatAreExactWhereTheyCanBe) {
  const Fraction seconds = fraction("30000/1001").inverse();
  EXPECT_EQ(seconds.time_of(decimal("30000")).to_string(), "1001");
  EXPECT_EQ(seconds.time_of(decimal("1")).to_string(), "0.033366666666666667");
  EXPECT_EQ(fraction("1/24").of(decimal("1")).to_double(), 1.0 / 24.0);
  EXPECT_EQ(fraction("1/24").time_of(decimal("36")).to_string(), "1.5");
}

TEST(IsoTime, IsSecondsSince1970) {
  for (const auto& [text, seconds] :
       {std::pair("1970-01-01T00:00:00Z", "0"), std::pair("2024-02-29T12:30:00.25Z", "1709209800.25"),
        std::pair("2024-060T12:30:00.25", "1709209800.25"), std::pair("2024-02-29t12:30z", "1709209800"),
        std::pair("2024-02-29 14:30:00+02:00", "1709209800"), std::pair("2024-02-29T09:00-0330", "1709209800"),
        std::pair("2024-02-29", "1709164800"), std::pair("2024-366T00:00:00", "1735603200"),
        std::pair("1969-12-31T23:59:59.999999999Z", "-0.000000001"), std::pair("2024-12-31T24:00:00Z", "1735689600"),
        std::pair("2023-07-14T08:00:00.123456789012Z", "1689321600.123456789012")})
    EXPECT_EQ(iso(text), seconds) << text;
}

TEST(IsoTime, CountsNoLeapSeconds) {
  EXPECT_EQ(iso("2016-12-31T23:59:60Z"), iso("2017-01-01T00:00:00Z"));
  EXPECT_EQ(parse_iso_time("2017-01-01T00:00:00Z").value() - parse_iso_time("2016-12-31T00:00:00Z").value(),
            decimal("86400"));
  EXPECT_EQ(iso("2016-12-31T23:59:60.5Z"), "1483228800.5");
}

TEST(IsoTime, RefusesWhatIsNone) {
  for (const char* text :
       {"2024-13-01T00:00:00Z", "2023-02-29", "2023-366", "2024-000", "2024-01-01T25:00", "2024-1-1",
        "2024-01-01T12:60:00", "2024-01-01T12:00:60Z", "2024-01-01T12:00:00.Z", "2024-01-01T12",
        "2024-01-01T12:00:00+1", "2024-01-01T12:00:00Zulu", "2024-01-01T24:00:01Z", "2024-", "2024-01-01X12:00"})
    EXPECT_EQ(iso(text),
              "found '" + std::string(text) + "', wanted a time of ISO 8601 such as 2024-02-29T12:30:00.25Z");
  for (const char* text : {"2024", "1e-05", "-2024-01", "202-01", "12-34"}) EXPECT_FALSE(looks_like_iso_time(text));
}

TEST(Clock, ReadsTimesAsPeopleTypeThem) {
  const Clock clock{.zero = parse_iso_time("2024-01-01T00:00:00Z").value(), .frames_per_second = fraction("24")};
  const auto time = [&](std::string_view text, const Clock& by) {
    const auto read = time_in(text, by);
    return read ? read->to_string() : read.error().message;
  };
  EXPECT_EQ(time("-2.5", clock), "-2.5");
  EXPECT_EQ(time("1/8", clock), "0.125");
  EXPECT_EQ(time("36f", clock), "1.5");
  EXPECT_EQ(time("2024-01-01T00:00:02.000000001Z", clock), "2.000000001");
  EXPECT_EQ(time("2024-01-01", {}), "1704067200");
  EXPECT_EQ(time("36f", {}), "found the frame '36f', wanted the frames per second as well");
  EXPECT_EQ(time("xf", clock), "found 'xf', wanted a frame such as 12f");
  EXPECT_EQ(time("now", clock),
            "found 'now', wanted a number of seconds, a fraction such as 1/24, a frame such as 12f, "
            "or a time such as 2024-02-29T12:30:00Z");
}

std::string times_in(std::string_view content, ReadOptions options = {}) {
  options.keep_exact_times = true;
  const TextFile file(content);
  const auto keys = read_keys(file.path(), options);
  if (!keys) return text_of(keys.error());
  std::string times;
  for (const Decimal& time : keys->exact_times) times += time.to_string() + " ";
  return times;
}

TEST(Clock, OfAFileOfKeys) {
  const std::string rows = ",1,0,0,0\n";
  const std::string dates = "t,qw,qx,qy,qz\n2024-01-01T00:00:00.000000001Z" + rows + "2024-01-01T00:00:01.5" + rows;
  EXPECT_EQ(times_in(dates), "1704067200.000000001 1704067201.5 ");
  EXPECT_EQ(times_in(dates, {.clock = {.zero = decimal("1704067200")}}), "0.000000001 1.5 ");
  EXPECT_EQ(times_in("t_ns,qw,qx,qy,qz\n2024-01-01" + rows), "1704067200 ");
  EXPECT_EQ(times_in("2024-01-01T00:00:00Z 0 0 0 0 0 0 1\n", {.format = &tum_format}), "1704067200 ");
  const std::string frames = "frame,qw,qx,qy,qz\n0" + rows + "1" + rows + "24" + rows;
  EXPECT_EQ(times_in(frames, {.clock = {.frames_per_second = fraction("24")}}), "0 0.041666666666666667 1 ");
  EXPECT_EQ(times_in(frames, {.time_scale = fraction("1/24")}), "0 0.041666666666666667 1 ");
  EXPECT_EQ(times_in("frame,t,qw,qx,qy,qz\n7,0.5" + rows), "0.5 ");
}

TEST(Clock, OfAFileOfKeysThatIsRefused) {
  const std::string rows = ",1,0,0,0\n";
  EXPECT_EQ(times_in("frame,qw,qx,qy,qz\n0" + rows),
            "keys.csv:1: the column 'frame' counts frames, wanted how many there are in a second (option fps)");
  EXPECT_EQ(times_in("t,qw,qx,qy,qz\n2024-01-01" + rows + "5" + rows),
            "keys.csv:3:1: key 1: found '5', wanted a time of ISO 8601 as in the rows before");
  EXPECT_EQ(times_in("t,qw,qx,qy,qz\n5" + rows + "2024-01-01" + rows),
            "keys.csv:3:1: key 1: found '2024-01-01', wanted a number as in the rows before");
  EXPECT_EQ(times_in("t,qw,qx,qy,qz\n2024-01-32" + rows),
            "keys.csv:2:1: key 0: found '2024-01-32', wanted a time of ISO 8601 such as 2024-02-29T12:30:00.25Z");
  EXPECT_TRUE(
      times_in("t,qw,qx,qy,qz\n2024-01-01" + rows, {.time_scale = fraction("2")}).find("which needs no scale") !=
      std::string::npos);
  EXPECT_EQ(times_in("t,qw,qx,qy,qz\n0" + rows, {.clock = {.frames_per_second = fraction("-1")}}),
            "[fps] found -1 frames per second, wanted a number greater than 0");
}

TEST(Clock, OfAFileOfTimes) {
  const auto times = [](std::string_view content, const Clock& clock) {
    const TextFile file(content, "times.txt");
    const auto list = read_times(file.path(), decimal("1704067200"), {.clock = clock});
    return list ? list->times : std::vector<double>();
  };
  EXPECT_EQ(times("2024-01-01T00:00:00.5Z\n2024-01-01\n", {}), (std::vector<double>{0.5, 0.0}));
  EXPECT_EQ(times("t\n2024-01-01T00:00:01Z\n", {.zero = decimal("-10")}), std::vector<double>{11.0});
  EXPECT_EQ(times("frame\n48\n", {.frames_per_second = fraction("24")}), std::vector<double>{2.0 - 1704067200.0});
  EXPECT_EQ(times("frame\n48\n", {}), std::vector<double>());
}

}}  // namespace orispline::io
