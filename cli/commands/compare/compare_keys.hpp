// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <orispline/io/track_file.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {

/// What is compared, and what was mended in INPUT.
struct ComparedFiles {
  std::shared_ptr<const Track> keys{}, reference{};
  io::RepairReport repairs;
};

/// Reads the recording and the keys. Errors: those of reading.
[[nodiscard]] Expected<ComparedFiles> compared_files(const InputRequest& input,
                                                     const std::optional<std::string>& reference);

}  // namespace orispline::cli
