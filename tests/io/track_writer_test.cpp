// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>

#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/sample_writer.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::ScratchDirectory;
using test::text_of;
using test::TextFile;

/// What a file of these tracks holds, or why it cannot be written.
std::string written(std::span<const Track> tracks, const SampleColumns& columns = {}) {
  const ScratchDirectory directory;
  auto file = OutputFile::open(directory.file("out.csv"));
  EXPECT_TRUE(file);
  if (auto done = write_tracks(*file, tracks, columns); !done) return text_of(done.error());
  EXPECT_TRUE(file->finish());
  return content_of(directory.file("out.csv"));
}
std::string written(const Track& track, const SampleColumns& columns = {}) { return written({&track, 1}, columns); }

Track track_in(const std::string& content, const ReadOptions& options = {}) {
  auto file = read_track(TextFile(content).path(), options, Signs::as_given);
  EXPECT_TRUE(file) << describe(file.error());
  return file ? file->track : Track();
}

TEST(WriteTracks, WritesTheColumnsThatAreAskedForAsFarAsKeysHaveThem) {
  const Track track =
      track_in("t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,tension\n1.25,1,0,0,0,1,2,3,4,5,6,0.5\n", {.parameters = {"tension"}});
  EXPECT_EQ(written(track, {.derivatives = 3}),
            "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,tension\n1.25,1,0,0,0,1,2,3,4,5,6,0.5\n");
  EXPECT_EQ(written(track), "t,qw,qx,qy,qz,px,py,pz,tension\n1.25,1,0,0,0,1,2,3,0.5\n");
  EXPECT_EQ(written(track, {.settings = {"bias", "tension"}}), written(track));  // settings are those of the track
  EXPECT_EQ(written(Track(track.keys), {.format = &tum_format}), "0 1 2 3 0 0 0 1\n");
}

TEST(WriteTracks, KeepsTheDigitsOfTheFileWhileTheyStateTheKey) {
  const std::string rows = "t,qw,qx,qy,qz\n0,0.70710678,0.70710678,0,0\n1,-0.6,0,0.8,0\n";
  const Track track = track_in(rows, {.keep_as_read = true});
  EXPECT_EQ(written(track), rows);
  EXPECT_NE(written(track_in(rows)), rows);
  const std::vector<std::size_t> second{1};
  EXPECT_EQ(written(track.at(second)), "t,qw,qx,qy,qz\n1,-0.6,0,0.8,0\n");
  const auto turned =
      Keyframes::make({.times = {0.0, 1.0}, .orientations = std::vector(2, quaternion_wxyz(0.0, 0.0, 0.0, 1.0))});
  EXPECT_EQ(written(track.with_keys(turned.value())), "t,qw,qx,qy,qz\n0,0,0,0,1\n1,0,0,0,1\n");
}

TEST(WriteTracks, WritesTheTableOfTheFileWithSettingsInTheirColumns) {
  Track track =
      track_in("time;note;qw;qx;qy;qz;tension\n1.250;a,b;1;0;0;0;0.50\n2.0;;1;0;0;0;0.50\n", {.keep_table = true});
  const std::string head = "time,note,qw,qx,qy,qz,tension", first = "\n1.250,\"a,b\",1,0,0,0,",
                    second = "\n2.0,,1,0,0,0,";
  EXPECT_EQ(written(track), head + first + "0.50" + second + "0.50\n");
  track.settings = {{"bias", {1.0, 2.0}}, {"tension", {0.25, 0.75}}};
  EXPECT_EQ(written(track), head + ",bias" + first + "0.25,1" + second + "0.75,2\n");
  track.settings.clear();
  EXPECT_EQ(written(track, {.format = &tum_format}), "1.25 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n");
  EXPECT_EQ(written(track.with_times({0.0, 3.0}).value()), "t,qw,qx,qy,qz\n1.25,1,0,0,0\n4.25,1,0,0,0\n");
}

TEST(WriteTracks, WritesAllKeysOfATrackThatIsLongerThanABlock) {
  constexpr std::size_t keys = 20'000;
  std::string rows = "t,qw,qx,qy,qz\n";
  for (std::size_t i = 0; i < keys; ++i) rows += std::to_string(1'000'000 + i) + ".5,0.5,-0.5,0.5,-0.5\n";
  ASSERT_GT(rows.size(), 2 * written_block);
  EXPECT_EQ(written(track_in(rows)), rows);
}

TEST(WriteTracks, SaysThatTheDiskIsFullInTheMiddleOfATrack) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  KeyframeData data{.times = std::vector<double>(20'000),
                    .orientations = std::vector(20'000, quaternion_wxyz(1.0, 0.0, 0.0, 0.0))};
  std::iota(data.times.begin(), data.times.end(), 1e9);
  const Track track(Keyframes::make(std::move(data)).value());
  auto file = OutputFile::open("/dev/full");
  const auto done = write_tracks(*file, {&track, 1}, {});
  ASSERT_FALSE(done);
  EXPECT_EQ(describe(done.error()), "/dev/full: cannot write: No space left on device");
}

TEST(WriteTracks, RefusesWhatTheFormatCannotHold) {
  Track track = track_in("t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n");
  EXPECT_EQ(written(std::vector{track, track}), "out.csv: found 2 tracks, and a CSV file holds one");
  EXPECT_EQ(written(std::vector<Track>(), {.format = &npy_format}),
            "out.csv: found 0 tracks, and a NumPy file holds one");
  track.settings = {{"tension", {0.5, 0.5}}};
  EXPECT_EQ(written(track, {.format = &euroc_format}), "1 columns of settings were asked for, and EuRoC holds 0");
}

TEST(WriteTracks, NamesTheKeyThatCannotBeWritten) {
  const Track track =
      track_in("t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n1.0000000001,1,0,0,0\n", {.keep_exact_times = true});
  EXPECT_EQ(written(track, {.format = &euroc_format}),
            "keys.csv:4: key 2: two samples fall on the nanosecond 1000000000, wanted times that differ in EuRoC");
}

// A format of several tracks that the library does not have: their names.

Expected<void> write_names(OutputFile& file, std::span<const Track> tracks, const SampleColumns&) {
  std::string names;
  for (const Track& track : tracks) names += track.name + "\n";
  return file.write(names);
}

constexpr FormatInfo written_names_format{.id = "names",
                                          .title = "Names",
                                          .file = "a Names file",
                                          .summary = "names of tracks",
                                          .writing = {.tracks = write_names}};

TEST(WriteTracks, WritesSeveralWhereTheFormatHoldsThem) {
  std::vector<Track> tracks(2);
  tracks[0].name = "hand";
  tracks[1].name = "foot";
  EXPECT_EQ(written(tracks, {.format = &written_names_format}), "hand\nfoot\n");
}

}}  // namespace orispline::io
