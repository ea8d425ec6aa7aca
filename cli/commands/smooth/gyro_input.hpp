// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <orispline/io/track_file.hpp>
#include <orispline/smooth.hpp>

namespace orispline::cli {

/// The rates of a gyro beside the keys of a file: those of a file of their own, which the options of reading for keys
/// are read by too, or else those of the rows of the file, with an orientation or without.
[[nodiscard]] Expected<std::shared_ptr<const GyroRates>> gyro_input(const io::TrackFile& file,
                                                                    const std::optional<std::string>& gyro_file,
                                                                    const io::ReadOptions& read);

}  // namespace orispline::cli
