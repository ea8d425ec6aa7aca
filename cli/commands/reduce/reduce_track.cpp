// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_track.hpp"

#include <algorithm>
#include <utility>

#include "options/output_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

Expected<void> write_rows(io::SampleWriter& writer, const ReducedTrack& track, const orispline::Reduction& reduction) {
  const auto& columns = reduction.track.settings;
  std::vector<double> settings(columns.size());
  for (std::size_t key = 0; key < reduction.samples.size(); ++key) {
    std::ranges::transform(columns, settings.begin(), [key](const auto& column) { return column.second[key]; });
    io::Sample sample{.motion = {.orientation = track.recording.written(reduction.track.keys.orientations()[key],
                                                                        reduction.samples[key])},
                      .settings = settings};
    if (!reduction.track.keys.positions().empty())
      sample.linear_motion.position = reduction.track.keys.positions()[key];
    auto written = writer.write(reduction.track.time_of(key), sample);
    if (written) continue;
    if (written.error().code != ErrorCode::bad_data) return written;
    written.error().where.key = reduction.samples[key];
    return tl::unexpected(track.recording.track.located(std::move(written.error())));
  }
  return writer.close();
}

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

Expected<UnfinishedKeys> write_keys(const std::string& path, io::SampleColumns columns, const ReducedTrack& track,
                                    const orispline::Reduction& reduction) {
  columns.positions = !track.samples().positions().empty();
  columns.derivatives = 0;
  for (const auto& [name, values] : reduction.track.settings) columns.settings.push_back(name);
  if (!columns.settings.empty() && !columns.format->holds.settings)
    return usage_failure(formatted("{}: {} has no column for {}, with which the tolerance holds, wanted {}", path,
                                   columns.format->file, columns.settings.front(), formats_for_settings()));
  return io::SampleWriter::open(path, columns, reduction.samples.size()).and_then([&](io::SampleWriter writer) {
    UnfinishedKeys output{std::move(writer), nullptr};
    output.removal = std::make_unique<RemovedWhenInterrupted>(output.writer.part());
    return write_rows(output.writer, track, reduction).map([&] { return std::move(output); });
  });
}

}  // namespace orispline::cli
