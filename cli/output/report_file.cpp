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
  InterruptionHeld held(*options.path);
  auto file = io::OutputFile::open(*options.path);
  if (!file) return tl::unexpected(std::move(file.error()));
  report.command_line_ = options.command_line;
  report.unfinished_ = std::make_unique<RemovedWhenInterrupted>(file->part(), held);
  report.file_ = std::move(*file);
  return report;
}

pages::PageHead ReportFile::head() const {
  return {.command = command_line_, .date = fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr)))};
}

Expected<void> ReportFile::finish() { return file_ ? file_->finish() : Expected<void>(); }

}  // namespace orispline::cli
