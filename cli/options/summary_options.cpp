// SPDX-License-Identifier: Apache-2.0
#include "options/summary_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

Expected<void> check_summary(const SummaryOptions& options, std::string_view output, std::string_view written) {
  if (!options.json || output != io::standard_stream) return {};
  return usage_failure(formatted("--json: the summary goes to standard output, wanted -o FILE for the {}", written));
}

}  // namespace orispline::cli
