// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/io/track_file.hpp>

#include "commands/compare/compare_request.hpp"

namespace orispline::cli {

/// What is compared with what, and what was mended in INPUT.
struct ComparedFiles {
  ComparedData data;
  io::RepairReport repairs;
};

/// Reads the recording and the keys. Errors: those of reading; bad_data for fewer than two keys and for a reference
/// that does not overlap them.
[[nodiscard]] Expected<ComparedFiles> compared_files(const CompareRequest& request,
                                                     const std::optional<std::string>& reference);

}  // namespace orispline::cli
