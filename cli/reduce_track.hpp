// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orispline/io/sample_writer.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/smooth/smooth.hpp>

#include "input_options.hpp"
#include "interruption.hpp"

namespace orispline::cli {

/// A recording as it was read, as it was checked, and as it is reduced.
struct Track {
  io::KeyFile file;  ///< without the samples
  std::vector<Eigen::Quaterniond> as_read;
  Keyframes raw;      ///< checked
  Keyframes samples;  ///< at the same times, smoothed where that was asked for
  std::optional<orispline::Smoothing> smoothing{};
};

/// Reads a recording, and smooths it where it is said how. Every error names the file.
[[nodiscard]] Expected<Track> open_track(const InputRequest& input,
                                         const std::optional<orispline::SmoothOptions>& smoothing);

/// Keys that are written beside their file, closed, and take its place when the writer finishes.
struct UnfinishedKeys {
  io::SampleWriter writer;
  std::unique_ptr<RemovedWhenInterrupted> removal;
};

/// Writes the keys; those that are samples with the digits of the file. Errors: those of the writer.
[[nodiscard]] Expected<UnfinishedKeys> write_keys(const std::string& path, io::SampleColumns columns,
                                                  const Track& track, const orispline::Reduction& reduction);

}  // namespace orispline::cli
