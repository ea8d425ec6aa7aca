// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include <orispline/align.hpp>
#include <orispline/io/track_file.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {

/// The rates of a gyro beside the keys of a file, whose epoch their times count from: those of a file of their own,
/// which the options of reading for keys are read by too, or else those of the rows of the file, with an orientation or
/// without.
[[nodiscard]] Expected<GyroTrack> gyro_beside(const io::TrackFile& file, const std::optional<std::string>& gyro_file,
                                              const io::ReadOptions& read);

/// A file of orientations, or the rates of a gyro in one that has no orientations.
using AlignedFile = std::variant<io::TrackFile, GyroTrack>;

[[nodiscard]] Expected<AlignedFile> read_moved(const InputRequest& input);

/// By the options of reading for the other file, as far as they fit.
[[nodiscard]] Expected<AlignedFile> read_fixed(const AlignedFile& moved, const std::string& path,
                                               const io::ReadOptions& read);

/// Writes rates into a file that appears complete or not at all.
[[nodiscard]] Expected<void> write_aligned_rates(const std::string& path, const GyroTrack& gyro);

}  // namespace orispline::cli
