// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/report/page.hpp>

#include "output/interruption.hpp"

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

/// Error (bad_argument): not the name of a file, or that of one of the others, which the report would replace.
[[nodiscard]] Expected<void> check_report(const ReportOptions& options, const std::vector<OtherFile>& others);

/// The file of `--report`; does nothing where none was asked for.
///
/// It is opened before the work, so that a wrong path is told at once, and takes the place of an older report only when
/// it is finished.
class ReportFile {
 public:
  /// Error: bad_access.
  [[nodiscard]] static Expected<ReportFile> open(const ReportOptions& options);
  /// Makes the page and writes it. Error: bad_access.
  [[nodiscard]] Expected<void> write(const std::function<report::Page()>& page);
  /// Error: bad_access.
  [[nodiscard]] Expected<void> finish();

 private:
  ReportFile() = default;

  std::optional<io::OutputFile> file_;
  std::unique_ptr<RemovedWhenInterrupted> unfinished_;
};

}  // namespace orispline::cli
