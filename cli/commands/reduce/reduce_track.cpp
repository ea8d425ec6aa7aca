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
    return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 or more", {.file = file->track.name});
  ReducedTrack track{.recording = std::move(*file), .reduced = {}};
  track.reduced = track.recording.track;
  return smoothing ? smoothed(std::move(track), *smoothing) : std::move(track);
}

}  // namespace orispline::cli
