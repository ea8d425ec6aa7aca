// SPDX-License-Identifier: Apache-2.0
#include "output/report_file.hpp"

#include <ctime>

#include <fmt/chrono.h>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

Expected<ReportFile> ReportFile::open(const ReportOptions& options) {
  ReportFile report;
  if (!options.path) return report;
  auto output = open_output(*options.path);
  if (!output) return tl::unexpected(std::move(output.error()));
  report.command_line_ = options.command_line;
  report.output_ = std::move(*output);
  return report;
}

pages::PageHead ReportFile::head() const {
  const std::tm now = fmt::localtime(std::time(nullptr));
  return {.command = command_line_,
          .date = formatted("{}-{:02}-{:02} {:02}:{:02}", 1900 + now.tm_year, 1 + now.tm_mon, now.tm_mday, now.tm_hour,
                            now.tm_min)};
}

Expected<void> ReportFile::finish() { return output_ ? output_->file.finish() : Expected<void>(); }

}  // namespace orispline::cli
