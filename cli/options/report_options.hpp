// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// `--report FILE` of a command, as typed.
struct ReportOptions {
  std::optional<std::string> path;
  std::string command_line;  ///< to make the report again
};

/// A file that the command reads or writes besides, and its name in a message: `INPUT`.
struct OtherFile {
  std::string_view name;
  std::string path;
};

/// Error (bad_argument): not the name of a file, or that of one of the others, which the report would replace; a build
/// without pages.
[[nodiscard]] Expected<void> check_report(const ReportOptions& options, const std::vector<OtherFile>& others);

}  // namespace orispline::cli
