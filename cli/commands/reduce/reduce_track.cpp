// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_track.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>

#include "options/output_options.hpp"

namespace orispline::cli {
namespace {

Expected<ReducedTrack> smoothed(ReducedTrack track, const orispline::SmoothOptions& options) {
  auto smoothing = orispline::smooth(track.reduced, options);
  if (!smoothing) return tl::unexpected(track.reduced.located(std::move(smoothing.error())));
  track.reduced = smoothing->track;
  track.smoothing = std::move(*smoothing);
  return track;
}

}  // namespace

Expected<ReducedTrack> open_track(const InputRequest& input, const std::optional<orispline::SmoothOptions>& smoothing) {
  io::ReadOptions read = input.read;
  read.keep_as_read = true;
  auto file = io::read_track(input.path, read, input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  if (file->track.keys.size() < 2)
    return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 at least to keep the fewest that suffice",
                   {.file = file->track.name});
  ReducedTrack track{.recording = std::move(*file), .reduced = {}};
  track.reduced = track.recording.track;
  return smoothing ? smoothed(std::move(track), *smoothing) : std::move(track);
}

Expected<void> check_settings_fit(const Track& keys, const io::SampleColumns& columns, const std::string& path) {
  if (keys.settings.empty() || columns.format->holds.settings) return {};
  return usage_failure(formatted("{}: {} has no column for {}, with which the tolerance holds, wanted {}", path,
                                 columns.format->file, keys.settings.begin()->first, formats_for_settings()));
}

}  // namespace orispline::cli
