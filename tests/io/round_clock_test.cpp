// SPDX-License-Identifier: Apache-2.0
// Clocks that come round, and times in two columns of which one counts weeks.
#include <orispline/io/round_clock.hpp>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/file_option.hpp>
#include <orispline/io/rates_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

std::string length_of(std::string_view text) {
  const auto round = clock_round_of(text);
  return round ? round->length.to_string() + (round->is_in_seconds ? " s" : "") : "none";
}

Expected<KeyFile> keys_of(const std::string& header, const std::vector<std::string>& times,
                          const StatedOptions& stated) {
  std::string text = header + ",qw,qx,qy,qz\n";
  for (const std::string& time : times) text += time + ",1,0,0,0\n";
  Reading reading;
  return take_options(reading, stated).and_then([&] { return read_keys(TextFile(text).path(), reading.options); });
}

std::vector<double> times_of(const Expected<KeyFile>& file) {
  return file ? file->data.times : std::vector<double>{-1.0, -1.0};
}

using Times = std::vector<double>;

TEST(ClockRound, IsAWeekOrADayOrACounter) {
  EXPECT_EQ(length_of("week"), "604800 s");
  EXPECT_EQ(length_of("day"), "86400 s");
  EXPECT_EQ(length_of("24bit*1us"), "16.777216 s");
  EXPECT_EQ(length_of("32bit*0.5ms"), "2147483.648 s");
  EXPECT_EQ(length_of("int16"), "65536");
  EXPECT_EQ(length_of("uint64"), "18446744073709551616");
  for (const char* text : {"", "month", "bit", "0bit", "65bit", "int", "int16*", "int16*us", "int16*0s", "int16*-1s",
                           "24bit*1", "week*1s", "1us*24bit", "24 bit"})
    EXPECT_EQ(length_of(text), "none") << text;
}

TEST(Unwrap, CountsOnWhereTheClockComesRound) {
  EXPECT_EQ(times_of(keys_of("t_us", {"16700000", "16750000", "22784", "72784"}, {{"unwrap", "24bit*1us"}})),
            (Times{0, 0.05, 0.1, 0.15}));
  EXPECT_EQ(times_of(keys_of("t", {"604799", "604799.5", "0", "0.5"}, {{"unwrap", "week"}})), (Times{0, 0.5, 1, 1.5}));
  EXPECT_EQ(times_of(keys_of("t_ms", {"-1", "0", "32767", "-32768", "-1", "0"}, {{"unwrap", "int16"}})),
            (Times{0, 0.001, 32.768, 32.769, 65.536, 65.537}));
}

TEST(Unwrap, PutsARowThatIsLateBehindItsRound) {
  const auto file = keys_of("t", {"604798", "0.5", "604799", "1"}, {{"unwrap", "week"}, {"sort", ""}});
  EXPECT_EQ(times_of(file), (Times{0, 1, 2.5, 3}));
}

TEST(Unwrap, IsRefusedWhereTheClockNeverComesRound) {
  EXPECT_EQ(text_of(keys_of("t", {"1", "2", "3"}, {{"unwrap", "week"}}).error()),
            "[unwrap] found times from 1 to 3, which never come round at 604800; wanted a clock that does, or no such "
            "option");
  EXPECT_NE(text_of(keys_of("t", {"1", "2", "604802", "1"}, {{"unwrap", "week"}}).error())
                .find("found the times 1 and 604802, wanted all within one round of 604800"),
            std::string::npos);
  EXPECT_NE(
      text_of(keys_of("t", {"2024-01-01"}, {{"unwrap", "week"}}).error()).find("wanted a counter that comes round"),
      std::string::npos);
  EXPECT_EQ(text_of(keys_of("t", {"1"}, {{"unwrap", "month"}}).error()),
            "[unwrap] found 'month', wanted week, day, or a counter such as 24bit*1us, int16 or uint32");
}

TEST(Unwrap, IsOfRatesInAFileOfTheirOwnToo) {
  const TextFile file("t_ms,wx,wy,wz\n65535,1,0,0\n0,2,0,0\n1,3,0,0\n");
  const auto rates = read_rates(Input(file.path()), {.clock = {.round = clock_round_of("int16")}});
  ASSERT_TRUE(rates) << describe(rates.error());
  EXPECT_EQ(rates->exact_times.back().to_string(), "65.537");
}

TEST(WeeksOfAColumn, AreAddedToTheTimeOfTheWeek) {
  const auto file = keys_of("GPS_Week,TOW", {"2250,604799.5", "2251,0", "2251,0.5"}, {{"columns", "t=GPS_Week+TOW"}});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.times, (Times{0, 0.5, 1}));
  EXPECT_EQ(file->epoch.to_string(), "1361404799.5");
  EXPECT_EQ(times_of(keys_of("week,iTOW", {"2250,604799500", "2251,0"}, {{"columns", "t=week+iTOW"}})),
            (Times{0, 0.5}));
}

}}  // namespace orispline::io
