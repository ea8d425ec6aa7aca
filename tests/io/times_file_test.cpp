// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/times_file.hpp>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text_file.hpp"

namespace orispline::io {
namespace {

using test::text_of;
using test::TextFile;

Expected<std::vector<double>> read(std::string_view content, std::string_view epoch = "0") {
  return read_times(TextFile(content, "times.txt").path(), Decimal::parse(epoch).value())
      .map([](const TimesList& list) { return list.times; });
}

std::string refusal(std::string_view content) {
  const auto times = read(content);
  return times ? "took it" : text_of(times.error());
}

using Times = std::vector<double>;

TEST(TimesFile, HoldsOneNumberALineInAnyOrder) {
  EXPECT_EQ(read("3\n1\n2\n2\n").value(), (Times{3, 1, 2, 2}));
  EXPECT_EQ(read("# comment\r\n\r\n 1e-3 \r\n+2\r\n").value(), (Times{0.001, 2}));
  EXPECT_EQ(read("1,\n2,\n").value(), (Times{1, 2}));
}

TEST(TimesFile, MayHaveAHeader) {
  for (const char* header : {"t", "time", "timestamp", "t_s", "\"t\""})
    EXPECT_EQ(read(std::string(header) + "\n1\n2\n").value(), (Times{1, 2})) << header;
  EXPECT_EQ(read("t_ms\n1500\n").value(), Times{1.5});
}

TEST(TimesFile, IsRelativeToTheEpochExactly) {
  EXPECT_EQ(read("1700000000.123456789\n1700000000\n1699999999.9\n", "1700000000").value(),
            (Times{0.123456789, 0, -0.1}));
  EXPECT_EQ(read("t_ns\n1700000000000000001\n", "1700000000").value(), Times{1e-9});
}

TEST(TimesFile, NamesTheLineOfWhatItRefuses) {
  EXPECT_EQ(refusal("1\n2\nabc\n"), "times.txt:3: found 'abc', wanted a number such as -1.5e-3");
  EXPECT_EQ(refusal("x\n1\n"), "times.txt:1: found 'x', wanted the header t or a number");
  EXPECT_EQ(refusal("t\nt\n"), "times.txt:2: found 't', wanted a number such as -1.5e-3");
  EXPECT_EQ(refusal("1\nnan\n"), "times.txt:2: found 'nan', wanted a finite time");
  EXPECT_EQ(refusal("1e999\n"), "times.txt:1: found '1e999', wanted a number between 1e-150 and 1e150 in size");
  EXPECT_EQ(refusal("1,2\n"), "times.txt:1: found 2 cells, wanted one time a line");
  EXPECT_EQ(refusal("t qw\n1 2\n"), "times.txt:1: found 2 cells, wanted one time a line");
  EXPECT_EQ(refusal(""), "times.txt: empty: no times");
  EXPECT_EQ(refusal("t\n# nothing\n"), "times.txt: empty: no times");
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

}  // namespace
}  // namespace orispline::io
