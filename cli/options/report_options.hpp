// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>

#include "options/file_places.hpp"

namespace orispline::cli {

/// `--report FILE` of a command, as typed.
struct ReportOptions {
  std::optional<std::string> path;
  std::string command_line;  ///< to make the report again
};

/// Error (bad_argument): not the name of a file, or that of one of the others, which the report would replace; a build
/// without pages.
[[nodiscard]] Expected<void> check_report(const ReportOptions& options, const std::vector<OtherFile>& others);

}  // namespace orispline::cli
