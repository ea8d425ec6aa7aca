// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/times_file.hpp>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

Expected<std::vector<double>> times_file(std::string_view content, std::string_view epoch = "0") {
  return read_times(TextFile(content, "times.txt").path(), Decimal::parse(epoch).value())
      .map([](const TimesList& list) { return list.times; });
}

std::string times_refusal(std::string_view content) {
  const auto times = times_file(content);
  return times ? "took it" : text_of(times.error());
}

using Times = std::vector<double>;

TEST(TimesFile, HoldsOneNumberALineInAnyOrder) {
  EXPECT_EQ(times_file("3\n1\n2\n2\n").value(), (Times{3, 1, 2, 2}));
  EXPECT_EQ(times_file("# comment\r\n\r\n 1e-3 \r\n+2\r\n").value(), (Times{0.001, 2}));
  EXPECT_EQ(times_file("1,\n2,\n").value(), (Times{1, 2}));
}

TEST(TimesFile, MayHaveAHeader) {
  EXPECT_EQ(times_file("qw,t,qx\n1,2,0\n1,1,0\n").value(), (Times{2, 1}));
  EXPECT_EQ(times_file("frame time\n7 2\n8 2.5\n").value(), (Times{2, 2.5}));
  for (const char* header : {"t", "time", "timestamp", "t_s", "\"t\""})
    EXPECT_EQ(times_file(std::string(header) + "\n1\n2\n").value(), (Times{1, 2})) << header;
  EXPECT_EQ(times_file("t_ms\n1500\n").value(), Times{1.5});
}

TEST(TimesFile, MayBeNamedByAComment) {
  const auto named = read_times(TextFile("# x,t_ms\n7,1500\n", "times.txt").path(), Decimal());
  ASSERT_TRUE(named) << text_of(named.error());
  EXPECT_EQ(named->times, Times{1.5});
  ASSERT_EQ(named->warnings.size(), 1u);
  EXPECT_EQ(named->warnings[0].code, "commented_header");
  const auto sentence = read_times(TextFile("# notes\n1\n", "times.txt").path(), Decimal());
  ASSERT_TRUE(sentence) << text_of(sentence.error());
  EXPECT_EQ(sentence->times, Times{1.0});
  EXPECT_TRUE(sentence->warnings.empty());
}

TEST(TimesFile, IsRelativeToTheEpochExactly) {
  EXPECT_EQ(times_file("1700000000.123456789\n1700000000\n1699999999.9\n", "1700000000").value(),
            (Times{0.123456789, 0, -0.1}));
  EXPECT_EQ(times_file("t_ns\n1700000000000000001\n", "1700000000").value(), Times{1e-9});
}

TEST(TimesFile, NamesTheLineOfWhatItRefuses) {
  EXPECT_EQ(times_refusal("1\n2\nabc\n"), "times.txt:3:1: found 'abc', wanted a number such as -1.5e-3");
  EXPECT_EQ(times_refusal("x\n1\n"),
            "times.txt:1: found 'x', wanted a column of times such as t, or numbers without a header");
  EXPECT_EQ(times_refusal("t\nt\n"), "times.txt:2:1: found 't', wanted a number such as -1.5e-3");
  EXPECT_EQ(times_refusal("1\nnan\n"), "times.txt:2:1: found 'nan', wanted a finite time");
  EXPECT_EQ(times_refusal("1e999\n"), "times.txt:1:1: found '1e999', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(times_refusal("1,2\n"),
            "times.txt:1: found 2 cells, wanted one time a line, or a header that names the column t");
  EXPECT_EQ(times_refusal("x,t\n1,2\n3\n"), "times.txt:3: found 1 cell, wanted the time in cell 2");
  EXPECT_EQ(times_refusal("t,time\n1,2\n"),
            "times.txt:1: 't' and 'time' could both be t, wanted one of them (option columns)");
  EXPECT_EQ(times_refusal(""), "times.txt: empty: no times");
  EXPECT_EQ(times_refusal("t\n# nothing\n"), "times.txt: empty: no times");
}

TEST(TimesFile, MayBeAnyFileOfKeys) {
  const std::string tum = "1 0 0 0 0 0 0 1\n2.5 0 0 0 0 0 0 1\n";
  EXPECT_EQ(times_file(tum).value(), (Times{1, 2.5}));
  EXPECT_EQ(
      times_file("#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"
                 "1500000000,0,0,0,1,0,0,0\n")
          .value(),
      Times{1.5});
  EXPECT_EQ(times_file("t_ms,roll_deg,pitch_deg,yaw_deg\n500,1,2,3\n").value(), Times{0.5});
  const TextFile bare("7,1,0,0,0\n8,1,0,0,0\n", "times.txt");
  EXPECT_EQ(read_times(bare.path(), Decimal(), {.order = QuaternionOrder::wxyz}).value().times, (Times{7, 8}));
  const TextFile named("qw,when_ms\n1,250\n", "times.txt");
  EXPECT_EQ(read_times(named.path(), Decimal(), {.columns = {{"t", "when_ms"}, {"qw", "qw"}}}).value().times,
            Times{0.25});
}

TEST(TimesFile, SaysWhichUnitItTakesBySize) {
  const TextFile file("1700000000000\n", "times.txt");
  const auto list = read_times(file.path(), Decimal::parse("1700000000").value()).value();
  EXPECT_EQ(list.times, Times{0});
  ASSERT_EQ(list.warnings.size(), 1U);
  EXPECT_EQ(list.warnings[0].code, "time_unit_by_size");
}

TEST(TimesFile, KnowsTheLineOfEachTime) {
  const TextFile file("# times\nt\n3\n\n1\n", "times.txt");
  EXPECT_EQ(read_times(file.path(), Decimal()).value().lines, (std::vector<std::uint32_t>{3, 5}));
}

TEST(TimesFile, MustExist) {
  const test::ScratchDirectory directory;
  const auto times = read_times(directory.file("absent.txt"), Decimal());
  ASSERT_FALSE(times);
  EXPECT_EQ(times.error().code, ErrorCode::bad_access);
  EXPECT_EQ(text_of(times.error()), "absent.txt: cannot open: No such file or directory");
}

}}  // namespace orispline::io
