// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>

#include <utility>

#include <orispline/base/file_name.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/line_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Expected<TrackFile> checked(KeyFile file, const ReadOptions& options, std::optional<Signs> signs) {
  if (signs) file.recipe.signs = *signs;
  KeyframeData data = std::exchange(file.data, {});
  if (options.keep_as_read) file.data.orientations = data.orientations;
  if (options.inverse_poses || !options.frames.is_none()) file.table = {};  // states the keys of other frames
  auto keys = Keyframes::make(std::move(data), file.recipe.signs);
  if (!keys) return tl::unexpected(located(file, std::move(keys.error())));
  return track_file(std::move(file), *keys);
}

/// Without what says how the file looks.
ReadOptions as_it_looks(ReadOptions options) {
  options.format = nullptr;
  options.columns.clear();
  options.order.reset();
  options.orientation = {};
  options.time_scale.reset();
  return options;
}

/// By the options where they fit, else as the file looks.
Expected<KeyReader> open_beside(const TrackFile& other, const Input& input, const ReadOptions& options) {
  ReadOptions fitting = options;
  fitting.time_scale.reset();
  if (extension_of(input.name()) != extension_of(other.track.name)) {
    fitting.format = nullptr;
    fitting.order.reset();
  }
  auto reader = KeyReader::open(input, fitting);
  if (!reader && reader.error().code != ErrorCode::bad_access)
    if (auto plain = KeyReader::open(input, as_it_looks(options))) return plain;
  if (!reader || !options.time_scale || &reader->format() != other.format) return reader;
  const KeyColumns* const columns = reader->columns();
  if (columns && columns->states_time_unit) return reader;
  fitting.time_scale = options.time_scale;
  return KeyReader::open(input, fitting);
}

}  // namespace

TrackFile track_file(KeyFile file, Keyframes keys) {  // NOLINT(performance-unnecessary-value-param): keys are shared
  TrackFile found{.format = file.format,
                  .repairs = file.repairs,
                  .unposed = std::move(file.unposed),
                  .ignored_columns = std::move(file.ignored_columns),
                  .warnings = std::move(file.warnings)};
  if (file.turns)
    for (Warning& warning : file.turns->warnings(file.recipe.signs, file.euler)) {
      warning.where.file = file.path;
      if (const auto key = warning.where.key; key && *key < file.lines.size()) warning.where.line = file.lines[*key];
      found.warnings.push_back(std::move(warning));
    }
  Track& track = found.track;
  track.keys = keys;
  track.name = std::move(file.path);
  track.epoch = file.epoch;
  track.lines = std::move(file.lines);
  track.exact_times = std::move(file.exact_times);
  track.settings = std::move(file.parameters);
  track.positions_apart = std::move(file.positions_apart);
  track.as_read = std::move(file.data.orientations);
  track.table = std::move(file.table);
  track.recipe = std::move(file.recipe);
  return found;
}

Expected<std::vector<TrackFile>> read_tracks(const Input& input, const ReadOptions& options,
                                             std::optional<Signs> signs) {
  auto files = read_all_keys(input, options);
  if (!files) return tl::unexpected(std::move(files.error()));
  std::vector<TrackFile> tracks;
  for (KeyFile& file : *files) {
    auto track = checked(std::move(file), options, signs);
    if (!track) return tl::unexpected(std::move(track.error()));
    tracks.push_back(std::move(*track));
  }
  return tracks;
}

Expected<TrackFile> read_track(const Input& input, const ReadOptions& options, std::optional<Signs> signs) {
  return read_keys(input, options).and_then([&](KeyFile file) { return checked(std::move(file), options, signs); });
}

Expected<TrackFile> read_track(KeyInput input, const ReadOptions& options, std::optional<Signs> signs) {
  return read_keys(std::move(input), options).and_then([&](KeyFile file) {
    return checked(std::move(file), options, signs);
  });
}

Expected<TrackFile> read_track_beside(const TrackFile& other, const Input& input, ReadOptions options) {
  options.recipe = RecipeUse::ignored;
  options.parameters.clear();
  options.keep_table = options.keep_as_read = options.keep_exact_times = false;
  if (options.session && !input.is_standard_input())
    if (const auto count = sessions_in(input, options); count && *count == 1) options.session.reset();
  auto reader = input.is_standard_input() ? KeyReader::open(input, options) : open_beside(other, input, options);
  return std::move(reader).and_then([](KeyReader keys) { return keys.next(); }).and_then([&](KeyFile file) {
    return checked(std::move(file), options, Signs::shortest);
  });
}

}}}  // namespace orispline::io
