// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_format.hpp>

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <orispline/base/formatted.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/line_reader.hpp>
#include <orispline/io/sample_writer.hpp>
#include <orispline/io/track_file.hpp>

#include "io/text_file.hpp"
#include "support/places.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::ScratchDirectory;
using test::text_of;
using test::TextFile;

TEST(Formats, StateWhatTheyAre) {
  std::set<std::string_view> ids;
  for (const FormatInfo* const format : formats()) {
    EXPECT_TRUE(ids.insert(format->id).second) << format->id;
    EXPECT_FALSE(format->title.empty() || format->summary.empty()) << format->id;
    EXPECT_NE(format->file.find(formatted(" {} file", format->title)), std::string_view::npos) << format->file;
    EXPECT_TRUE(format->is_read() || format->is_written()) << format->id;
    ASSERT_FALSE(format->extensions.empty()) << format->id;
    for (const std::string_view extension : format->extensions) {
      EXPECT_TRUE(extension.starts_with('.')) << format->id;
      EXPECT_TRUE(format->has_extension_of(formatted("keys{}", extension))) << format->id;
    }
  }
}

TEST(Formats, ThatAreWrittenAndReadGiveBackWhatTheyHold) {
  const Eigen::Vector3d position(1.5, -2.25, 3.0), rate(0.125, -0.5, 2.0);
  const Sample sample{.motion = {.orientation = quaternion_wxyz(0.5, -0.5, 0.5, -0.5), .angular_velocity = rate},
                      .linear_motion = {.position = position}};
  for (const FormatInfo* const format : formats()) {
    if (!format->is_read() || !format->is_written()) continue;
    SCOPED_TRACE(format->id);
    const ScratchDirectory directory;
    const std::string path = directory.file("keys");
    auto writer =
        SampleWriter::open(path, {.format = format, .positions = true, .derivatives = format->holds.rates ? 1 : 0}, 2);
    ASSERT_TRUE(writer && writer->write(Decimal::parse("1.25").value(), sample) &&
                writer->write(Decimal::parse("3.5").value(), sample) && writer->finish());
    const auto file = read_keys(path, {.format = format});
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->format, format);
    EXPECT_EQ(file->epoch.to_string(), "1.25");
    EXPECT_EQ(file->data.times, (std::vector<double>{0.0, 2.25}));
    EXPECT_EQ(file->data.orientations[1], sample.motion.orientation);
    EXPECT_EQ(file->data.positions[1], position);
    EXPECT_EQ(file->data.angular_velocities.empty(), !format->holds.rates);
    if (format->holds.rates) {
      EXPECT_EQ(file->data.angular_velocities[1], rate);
    }
  }
}

TEST(Formats, AreNamedInMessages) {
  EXPECT_EQ(any_of({}), "");
  EXPECT_EQ(any_of(formats().first(1)), "CSV");
  EXPECT_EQ(any_of(formats().first(2)), "CSV or TUM");
  EXPECT_EQ(any_of(formats().first(3)), "CSV, TUM or EuRoC");
}

std::string row_of(const FormatInfo& format) {
  const auto yes = [](bool is_so) { return is_so ? "yes" : "no"; };
  std::string extensions = joined(format.extensions, ", ", "`{}`");
  return formatted("| {} | `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", format.title, format.id, extensions,
                   format.summary, yes(format.is_read()), yes(format.is_written()),
                   format.holds.forms ? "any form" : "quaternions", format.holds.always_positions ? "always" : "yes",
                   yes(format.holds.rates), yes(format.holds.settings),
                   format.keeps_times()         ? "exact"
                   : format.writing.whole_times ? formatted("whole {}s", format.writing.whole_times->unit)
                                                : "doubles");
}

TEST(Formats, StandInTheDocumentsAsInTheList) {
  std::string rows;
  for (const FormatInfo* const format : formats()) rows += row_of(*format);
  EXPECT_NE(content_of(testing_support::in_project("docs/files.md")).find(rows + "\n"), std::string::npos) << rows;
}

// A format that the library does not have: a count of tracks, one key each, as lines `track NAME`.

Expected<std::vector<KeyFile>> tracks_in(LineReader lines, const ReadOptions&) {
  std::vector<KeyFile> tracks;
  for (auto line = lines.next(); line && *line; line = lines.next())
    tracks.push_back({.path = std::string(**line),
                      .data = {.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}},
                      .lines = {static_cast<std::uint32_t>(lines.line())}});
  return tracks;
}

constexpr FormatInfo read_names_format{.id = "names",
                                       .title = "Names",
                                       .file = "a Names file",
                                       .summary = "names of tracks that stand still",
                                       .reading = {.tracks = tracks_in}};

TEST(Formats, MayBeACallersOwnAndHoldSeveralTracks) {
  const TextFile file("hand\nfoot\n");
  const auto tracks = read_all_keys(file.path(), {.format = &read_names_format});
  ASSERT_TRUE(tracks) << describe(tracks.error());
  ASSERT_EQ(tracks->size(), 2u);
  EXPECT_EQ(tracks->back().path, "foot");
  const auto checked = read_tracks(file.path(), {.format = &read_names_format});
  ASSERT_TRUE(checked) << describe(checked.error());
  EXPECT_EQ(checked->front().track.name, "hand");
  EXPECT_EQ(checked->back().track.keys.size(), 1u);
  auto reader = KeyReader::open(TextFile("hand\n").path(), {.format = &read_names_format}).value();
  EXPECT_EQ(reader.bytes_read(), 0u);  // nobody counts them where there is no table
  EXPECT_FALSE(reader.columns());
  const auto one = read_keys(file.path(), {.format = &read_names_format});
  EXPECT_EQ(text_of(one.error()), "keys.csv: found 2 tracks, wanted a file of one");
  const auto writer = SampleWriter::open("-", {.format = &read_names_format});
  EXPECT_EQ(writer.error().message, "Names files are not written, wanted " + any_of(formats_written()));
}

}}  // namespace orispline::io
