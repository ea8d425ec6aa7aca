// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// A track as a file holds it, with what reading did to it.
struct TrackFile {
  Track track{};
  const FormatInfo* format = &csv_format;
  RepairReport repairs{};
  RateRows unposed{};                          ///< rows without an orientation; only if asked for
  std::vector<std::string> ignored_columns{};  ///< that nothing was read from
  std::vector<Warning> warnings{};             ///< of reading
};

/// Reads the tracks of a file, one at least, and checks their keys. Signs that are not
/// given are those of the file's recipe, else for the shortest way.
///
/// Errors name the file, the line and the column or the key: those of read_keys() and of Keyframes::make().
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<TrackFile>> read_tracks(const Input& input,
                                                                            const ReadOptions& options = {},
                                                                            std::optional<Signs> signs = {});
/// The track of a file of one.
[[nodiscard]] ORISPLINE_EXPORT Expected<TrackFile> read_track(const Input& input, const ReadOptions& options = {},
                                                              std::optional<Signs> signs = {});
/// The track of a file of one that was opened before.
[[nodiscard]] ORISPLINE_EXPORT Expected<TrackFile> read_track(KeyInput input, const ReadOptions& options,
                                                              std::optional<Signs> signs = {});

/// The track of a file that stands beside another, such as the truth that keys are compared with, and is read by the
/// options that were stated for that one, as far as they fit: `--euler` does where it has such angles. An `order` and a
/// `format` count where both names have the same extension, a `time_scale` where both files are of the same format and
/// this one states no unit, a `session` where it has several. Its recipe, settings and signs do not count.
///
/// Standard input can be read once only: the options hold for it as they are. Errors: those of read_track().
[[nodiscard]] ORISPLINE_EXPORT Expected<TrackFile> read_track_beside(const TrackFile& other, const Input& input,
                                                                     ReadOptions options);

/// What was read of a file, with its keys when they have been checked; the file's recipe states their signs.
[[nodiscard]] ORISPLINE_EXPORT TrackFile track_file(KeyFile file, Keyframes keys);

/// Whether a file with these columns says which curve the keys are for: the format has comments, and room for the rates
/// and inner quaternions that are part of them.
[[nodiscard]] ORISPLINE_EXPORT bool states_recipe(const Track& track, const SampleColumns& columns);

/// `recipe_not_stated`: the keys are for the curve of a method, and a file with these columns cannot say so.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Warning> recipe_not_stated(const Track& track,
                                                                        const SampleColumns& columns,
                                                                        std::string_view file);

/// Writes keys into an open file, which is left to be closed.
///
/// A track that carries its table is written as its file has it, with its settings in their columns, where the format
/// has tables. Every other one is written in these columns, but with positions, inner quaternions and settings where it
/// has them and with no more rates than its keys have; quaternions keep the digits of its file. Where states_recipe(),
/// the track's recipe is a comment above.
///
/// Errors: bad_access; bad_argument for what the format cannot hold, several tracks among it; bad_data with the key.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> write_tracks(OutputFile& file, std::span<const Track> tracks,
                                                           const SampleColumns& columns);

}}}  // namespace orispline::io
