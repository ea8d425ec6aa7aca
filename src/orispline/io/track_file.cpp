// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>

#include <utility>

namespace orispline::inline ORISPLINE_ABI::io {
namespace {

Expected<TrackFile> checked(KeyFile file, const ReadOptions& options, std::optional<Signs> signs) {
  if (signs) file.recipe.signs = *signs;
  KeyframeData data = std::exchange(file.data, {});
  if (options.keep_as_read) file.data.orientations = data.orientations;
  auto keys = Keyframes::make(std::move(data), file.recipe.signs);
  if (!keys) return tl::unexpected(located(file, std::move(keys.error())));
  return track_file(std::move(file), std::move(*keys));
}

}  // namespace

TrackFile track_file(KeyFile file, Keyframes keys) {
  TrackFile found{.format = file.format,
                  .repairs = file.repairs,
                  .ignored_columns = std::move(file.ignored_columns),
                  .warnings = std::move(file.warnings)};
  Track& track = found.track;
  track.keys = std::move(keys);
  track.name = std::move(file.path);
  track.epoch = file.epoch;
  track.lines = std::move(file.lines);
  track.exact_times = std::move(file.exact_times);
  track.settings = std::move(file.parameters);
  track.as_read = std::move(file.data.orientations);
  track.table = std::move(file.table);
  track.recipe = std::move(file.recipe);
  return found;
}

Expected<std::vector<TrackFile>> read_tracks(const std::string& path, const ReadOptions& options,
                                             std::optional<Signs> signs) {
  auto files = read_all_keys(path, options);
  if (!files) return tl::unexpected(std::move(files.error()));
  std::vector<TrackFile> tracks;
  for (KeyFile& file : *files) {
    auto track = checked(std::move(file), options, signs);
    if (!track) return tl::unexpected(std::move(track.error()));
    tracks.push_back(std::move(*track));
  }
  return tracks;
}

Expected<TrackFile> read_track(const std::string& path, const ReadOptions& options, std::optional<Signs> signs) {
  return read_keys(path, options).and_then([&](KeyFile file) { return checked(std::move(file), options, signs); });
}

Expected<TrackFile> read_track(KeyInput input, const ReadOptions& options, std::optional<Signs> signs) {
  return read_keys(std::move(input), options).and_then([&](KeyFile file) {
    return checked(std::move(file), options, signs);
  });
}

}  // namespace orispline::inline ORISPLINE_ABI::io
