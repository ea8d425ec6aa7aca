// SPDX-License-Identifier: Apache-2.0
#include "options/report_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>

#include "options/has_pages.hpp"
#include "options/option_text.hpp"

namespace orispline::cli {

Expected<void> check_report(const ReportOptions& options, const std::vector<OtherFile>& others) {
  if (!options.path) return {};
  if (options.path->empty() || *options.path == io::standard_stream)
    return wanted({"--report", *options.path}, "the name of a file");
  if (const std::string lost = lost_with(*options.path, others); !lost.empty())
    return wanted({"--report", *options.path}, formatted("another file than {}", lost));
  if (!has_pages)
    return usage_failure("--report: orispline was built without pages, wanted a build with ORISPLINE_PAGE");
  return {};
}

}  // namespace orispline::cli
