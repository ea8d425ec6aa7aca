// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/track_file.hpp>

namespace orispline::cli {

/// Writes keys as io::write_tracks() does into a file that appears complete or not at all, also when the command is
/// interrupted.
[[nodiscard]] Expected<void> write_keys(const std::string& path, const Track& keys,
                                        const io::SampleColumns& columns = {});

}  // namespace orispline::cli
