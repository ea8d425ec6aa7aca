// SPDX-License-Identifier: Apache-2.0
// Bytes in memory are read and written as those of files.
#include <orispline/io/input.hpp>

#include <string>

#include <gtest/gtest.h>

#include <orispline/files.hpp>
#include <orispline/io/line_reader.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::ScratchDirectory;
using test::TextFile;

const std::string three_rows = "t,qw,qx,qy,qz\n5,1,0,0,0\n6,0.8,0,0,0.6\n8,0.6,0,0,0.8\n";
const std::string two_tum_rows = "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 1 0\n";

TEST(InputInMemory, HoldsTracksAsAFileDoes) {
  const TextFile file(three_rows);
  const auto read = read_track(Input::in_memory("keys.csv", three_rows)).value().track;
  const auto of_file = read_track(file.path()).value().track;
  EXPECT_EQ(read.name, "keys.csv");
  EXPECT_EQ(read.lines, of_file.lines);
  EXPECT_EQ(read.epoch, of_file.epoch);
  ASSERT_EQ(read.keys.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(read.keys.orientations()[i].coeffs(), of_file.keys.orientations()[i].coeffs());
}

TEST(InputInMemory, IsOfTheFormatThatItsNameOrItsRowsSay) {
  EXPECT_EQ(read_track(Input::in_memory("poses.tum", two_tum_rows))->format, &tum_format);
  EXPECT_EQ(read_track(Input::in_memory("", two_tum_rows))->format, &tum_format);
  EXPECT_EQ(read_track(Input::in_memory("-", three_rows))->format, &csv_format);  // not standard input
}

TEST(InputInMemory, IsNamedByErrors) {
  const auto message = [](const std::string& text) {
    return describe(read_track(Input::in_memory("keys.csv", text)).error());
  };
  EXPECT_EQ(message("t,qw,qx,qy,qz\n0,1,0,0,zero\n"),
            "keys.csv:2:5: key 0: found 'zero', wanted a number such as -1.5e-3");
  EXPECT_EQ(message(""), "keys.csv: empty: no keys");
  EXPECT_EQ(message(std::string(LineReader::longest_line + (1 << 17), 'x')),
            "keys.csv:1: the line is longer than 16 MiB, wanted a text file");
}

TEST(InputInMemory, IsReadAsOftenAsItIsWanted) {
  std::string two_recordings = "t,qw,qx,qy,qz\n";
  for (const char* t : {"1", "2", "3", "4", "1.5", "2.5", "3.5"}) two_recordings += std::string(t) + ",1,0,0,0\n";
  const Input input = Input::in_memory("keys.csv", two_recordings);
  EXPECT_EQ(sessions_in(input, {}).value(), 2u);
  EXPECT_EQ(read_tracks(input, {.session = all_sessions}).value().size(), 2u);
  EXPECT_EQ(read_keys(input, {.session = 2}).value().data.times, (std::vector<double>{0.0, 1.0, 2.0}));
}

TEST(InputInMemory, HoldsWhatElseIsRead) {
  EXPECT_EQ(read_times(Input::in_memory("times.txt", "1\n2.5\n"), Decimal()).value().times,
            (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(read_rates(Input::in_memory("gyro.csv", "t,wx,wy,wz\n0,1,2,3\n1,4,5,6\n")).value().rates.size(), 2u);
  EXPECT_EQ(describe(read_blending(Input::in_memory("mine.json", "{")).error()).find("mine.json"), 0u);
  const TrackFile keys = read_track(Input::in_memory("keys.csv", three_rows)).value();
  EXPECT_EQ(read_track_beside(keys, Input::in_memory("truth.csv", three_rows), {}).value().track.keys.size(), 3u);
}

TEST(OutputInMemory, HoldsWhatAFileWouldHold) {
  const Track track = read_track(Input::in_memory("keys.csv", three_rows)).value().track;
  const ScratchDirectory directory;
  for (const FormatInfo* format : formats_written()) {
    if (format == &npy_format) continue;  // of samples alone
    const SampleColumns columns{.format = format, .derivatives = 0};
    auto memory = OutputFile::in_memory("keys"), file = OutputFile::open(directory.file("keys")).value();
    ASSERT_TRUE(write_tracks(memory, {&track, 1}, columns) && memory.finish());
    ASSERT_TRUE(write_tracks(file, {&track, 1}, columns) && file.finish());
    EXPECT_EQ(std::move(memory).bytes(), content_of(directory.file("keys"))) << format->id;
  }
}

TEST(OutputInMemory, HoldsSamplesAndTheirNumber) {
  const ScratchDirectory directory;
  for (const FormatInfo* format : formats_written()) {
    const SampleColumns columns{.format = format};
    auto memory = SampleWriter::open(OutputFile::in_memory("samples"), columns).value();
    auto file = SampleWriter::open(directory.file("samples"), columns).value();
    for (SampleWriter* const writer : {&memory, &file}) {
      for (const double t : {1.0, 1.5, 2.0}) ASSERT_TRUE(writer->write(Decimal::from_double(t), Sample{}));
      ASSERT_TRUE(writer->finish());
    }
    EXPECT_EQ(std::move(memory).bytes(), content_of(directory.file("samples"))) << format->id;
  }
}

}}  // namespace orispline::io
