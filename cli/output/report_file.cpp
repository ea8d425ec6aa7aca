// SPDX-License-Identifier: Apache-2.0
#include "output/report_file.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "options/output_options.hpp"

namespace orispline::cli {
namespace {

/// Where a file is, or would be; as it stands where that cannot be said.
std::filesystem::path place_of(const std::string& path) {
  std::error_code unknown;
  auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
  return unknown ? std::filesystem::path(path) : place;
}

}  // namespace

Expected<void> check_report(const ReportOptions& options, const std::vector<OtherFile>& others) {
  if (!options.path) return {};
  if (options.path->empty() || *options.path == io::standard_stream)
    return wanted({"--report", *options.path}, "the name of a file");
  for (const OtherFile& other : others)
    if (other.path != io::standard_stream && place_of(other.path) == place_of(*options.path))
      return wanted({"--report", *options.path}, fmt::format("another file than {}", other.name));
  return {};
}

Expected<ReportFile> ReportFile::open(const ReportOptions& options) {
  ReportFile report;
  if (!options.path) return report;
  auto file = io::OutputFile::open(*options.path);
  if (!file) return tl::unexpected(std::move(file.error()));
  report.unfinished_ = std::make_unique<RemovedWhenInterrupted>(file->part());
  report.file_ = std::move(*file);
  return report;
}

Expected<void> ReportFile::write(const std::function<report::Page()>& page) {
  return file_ ? file_->write(report::document(page())) : Expected<void>();
}

Expected<void> ReportFile::finish() { return file_ ? file_->finish() : Expected<void>(); }

}  // namespace orispline::cli
