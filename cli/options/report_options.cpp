// SPDX-License-Identifier: Apache-2.0
#include "options/report_options.hpp"

#include <filesystem>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>

#include "options/has_pages.hpp"
#include "options/option_text.hpp"

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
      return wanted({"--report", *options.path}, formatted("another file than {}", other.name));
  if (!has_pages)
    return usage_failure("--report: orispline was built without pages, wanted a build with ORISPLINE_PAGE");
  return {};
}

}  // namespace orispline::cli
