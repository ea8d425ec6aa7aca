// SPDX-License-Identifier: Apache-2.0
#include "output/report_file.hpp"

#include <array>
#include <ctime>
#include <string>

namespace orispline::cli {

namespace {

/// To the minute, as clocks show it here.
std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, sizeof "2026-01-31 23:59"> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
  return text.data();
}

}  // namespace

Expected<ReportFile> ReportFile::open(const ReportOptions& options) {
  ReportFile report;
  if (!options.path) return report;
  auto output = open_output(*options.path);
  if (!output) return tl::unexpected(std::move(output.error()));
  report.command_line_ = options.command_line;
  report.output_ = std::move(*output);
  return report;
}

pages::PageHead ReportFile::head() const { return {.command = command_line_, .date = time_of_day()}; }

Expected<void> ReportFile::finish() { return output_ ? output_->file.finish() : Expected<void>(); }

}  // namespace orispline::cli
