// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/line_reader.hpp>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

using namespace std::string_literals;

/// All lines; the error's text after them if there is one.
std::vector<std::string> lines_of(const std::string& path) {
  auto reader = LineReader::open(path);
  if (!reader) return {text_of(reader.error())};
  std::vector<std::string> lines;
  for (;;) {
    const auto line = reader->next();
    if (!line) lines.push_back(text_of(line.error()));
    if (!line || !*line) return lines;
    lines.emplace_back(**line);
    EXPECT_EQ(reader->line(), lines.size());
  }
}

std::vector<std::string> lines_in(std::string_view content) { return lines_of(TextFile(content).path()); }

using Lines = std::vector<std::string>;

TEST(LineReader, TakesEveryEndOfLine) {
  EXPECT_EQ(lines_in("a\nb\n"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_in("a\r\nb\r\n"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_in("a\nb"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_in("a\r\nb\r"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_in("\n\na\n"), (Lines{"", "", "a"}));
  EXPECT_EQ(lines_in(""), Lines{});
}

TEST(LineReader, GivesLinesOnceMoreThatItKept) {
  const std::string long_line(100'000, 'x');
  const TextFile file("\xEF\xBB\xBFt\n" + long_line + "\nlast\n");
  auto reader = LineReader::open(file.path());
  ASSERT_TRUE(reader);
  reader->keep();
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(reader->next());
  reader->rewind();
  EXPECT_EQ(reader->line(), 0u);
  EXPECT_EQ(**reader->next(), "t");
  EXPECT_EQ(**reader->next(), long_line);
  EXPECT_EQ(**reader->next(), "last");
  EXPECT_FALSE(*reader->next());
}

TEST(LineReader, GivesAllBytesAsTheyAre) {
  const std::string whole = "\xEF\xBB\xBFt\r\n" + std::string(200'000, '\0');
  const TextFile file(whole);
  for (const Input& input : {Input(file.path()), Input::in_memory("keys.csv", whole)}) {
    auto reader = LineReader::open(input);
    ASSERT_TRUE(reader);
    EXPECT_EQ(std::move(*reader).bytes(), whole);
  }
}

TEST(LineReader, SkipsTheByteOrderMark) {
  EXPECT_EQ(lines_in("\xEF\xBB\xBFt\n1\n"), (Lines{"t", "1"}));
  EXPECT_EQ(lines_in("\xEF\xBB\xBF"), (Lines{""}));
}

TEST(LineReader, RefusesWhatIsNoText) {
  EXPECT_EQ(lines_in("a\nb\0c\n"s), (Lines{"a", "keys.csv:2: found a NUL byte, wanted a text file"}));
  EXPECT_EQ(lines_in("\xFF\xFEt\0\n"s), (Lines{"keys.csv:1: the file is UTF-16 text, wanted UTF-8"}));
  EXPECT_EQ(lines_in("a\rb\rc\n"),
            (Lines{"keys.csv:1: found a carriage return within the line, wanted lines that end in LF or CRLF"}));
}

TEST(LineReader, TakesLinesLongerThanItsChunks) {
  const std::string a(65535, 'a'), b(65536, 'b'), c(1 << 20, 'c'), d(200'000, 'd');
  EXPECT_EQ(lines_in(a + "\n" + b + "\r\n" + c + "\n\n" + d), (Lines{a, b, c, "", d}));
}

TEST(LineReader, RefusesEndlessLines) {
  EXPECT_EQ(lines_in("a\n" + std::string(LineReader::longest_line + (1 << 17), 'x')),
            (Lines{"a", "keys.csv:2: the line is longer than 16 MiB, wanted a text file"}));
}

TEST(LineReader, ReadsStandardInputForADash) {
  const TextFile file("a\nb\n");
  const int terminal = ::dup(0);
  ASSERT_NE(std::freopen(file.path().c_str(), "rb", stdin), nullptr);

  EXPECT_EQ(lines_of("-"), (Lines{"a", "b"}));

  ::dup2(terminal, 0);
  ::close(terminal);
  std::clearerr(stdin);
}

TEST(LineReader, SaysWhyAFileCannotBeRead) {
  const test::ScratchDirectory directory;
  EXPECT_EQ(lines_of(directory.file("absent.csv")), (Lines{"absent.csv: cannot open: No such file or directory"}));
  std::filesystem::create_directory(directory.file("folder"));
  EXPECT_EQ(lines_of(directory.file("folder")), (Lines{"folder: cannot read: Is a directory"}));
  EXPECT_EQ(LineReader::open(directory.file("absent.csv")).error().code, ErrorCode::bad_access);
}

}}  // namespace orispline::io
