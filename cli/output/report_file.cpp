// SPDX-License-Identifier: Apache-2.0
#include "output/report_file.hpp"

#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

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
  return {.command = command_line_, .date = fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr)))};
}

Expected<void> ReportFile::finish() { return output_ ? output_->file.finish() : Expected<void>(); }

}  // namespace orispline::cli
