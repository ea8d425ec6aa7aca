// SPDX-License-Identifier: Apache-2.0
#include "reduce_track.hpp"

#include <cmath>
#include <utility>

namespace orispline::cli {
namespace {

/// The digits of the file where the key is a sample of unit norm.
Eigen::Quaterniond written_quaternion(const Track& track, const orispline::Reduction& reduction, std::size_t key) {
  const Eigen::Quaterniond &found = reduction.keys.orientations()[key],
                           &as_read = track.as_read[reduction.samples[key]];
  const double sign = as_read.dot(found) < 0.0 ? -1.0 : 1.0;
  const Eigen::Quaterniond turned(sign * as_read.coeffs());
  const bool is_sample = std::abs(as_read.norm() - 1.0) <= unit_norm_tolerance &&
                         (turned.coeffs().normalized() - found.coeffs()).norm() <= 4e-16;
  return is_sample ? turned : found;
}

Expected<void> write_rows(io::SampleWriter& writer, const Track& track, const orispline::Reduction& reduction) {
  for (std::size_t key = 0; key < reduction.samples.size(); ++key) {
    io::Sample sample{.motion = {.orientation = written_quaternion(track, reduction, key)}};
    if (!reduction.keys.positions().empty()) sample.linear_motion.position = reduction.keys.positions()[key];
    auto written = writer.write(track.file.exact_times[reduction.samples[key]], sample);
    if (written) continue;
    if (written.error().code != ErrorCode::bad_data) return written;
    written.error().where.key = reduction.samples[key];
    return tl::unexpected(located(track.file, std::move(written.error())));
  }
  return writer.close();
}

Expected<Track> smoothed(Track track, const orispline::SmoothOptions& options) {
  auto smoothing = orispline::smooth(track.raw, options);
  if (!smoothing) return tl::unexpected(located(track.file, std::move(smoothing.error())));
  auto samples = orispline::smoothed_keyframes(track.raw, *smoothing);
  if (!samples) return tl::unexpected(located(track.file, std::move(samples.error())));
  track.samples = std::move(*samples);
  track.smoothing = std::move(*smoothing);
  return track;
}

}  // namespace

Expected<Track> open_track(const InputRequest& input, const std::optional<orispline::SmoothOptions>& smoothing) {
  auto file = io::read_keys(input.path, input.read);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto as_read = file->data.orientations;
  const auto samples = Keyframes::make(std::exchange(file->data, {}), input.signs);
  if (!samples) return tl::unexpected(located(*file, samples.error()));
  if (samples->size() < 2)
    return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 at least to keep the fewest that suffice",
                   {.file = file->path});
  Track track{.file = std::move(*file), .as_read = std::move(as_read), .raw = *samples, .samples = *samples};
  return smoothing ? smoothed(std::move(track), *smoothing) : std::move(track);
}

Expected<UnfinishedKeys> write_keys(const std::string& path, io::SampleColumns columns, const Track& track,
                                    const orispline::Reduction& reduction) {
  columns.positions = !track.samples.positions().empty();
  columns.derivatives = 0;
  return io::SampleWriter::open(path, columns, reduction.samples.size()).and_then([&](io::SampleWriter writer) {
    UnfinishedKeys output{std::move(writer), nullptr};
    output.removal = std::make_unique<RemovedWhenInterrupted>(output.writer.part());
    return write_rows(output.writer, track, reduction).map([&] { return std::move(output); });
  });
}

}  // namespace orispline::cli
