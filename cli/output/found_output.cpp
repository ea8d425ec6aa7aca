// SPDX-License-Identifier: Apache-2.0
#include "output/found_output.hpp"

#include <orispline/base/formatted.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

Expected<io::SampleColumns> columns_of_made(const OutputOptions& output, const SummaryOptions& summary,
                                            const MadeOutput& made, const std::vector<OtherFile>& others) {
  if (writes_file(output))
    return check_summary(summary, output.path, made.name)
        .and_then([&] { return check_output_apart(output.option, output.path, others); })
        .and_then([&] { return output_columns(output); });
  const auto no_file = [&made](std::string_view option) {
    return usage_failure(formatted("{}: found no -o, wanted -o FILE for {}", option, made.whole_name));
  };
  if (summary.quiet) return no_file("--quiet");
  for (const auto& [name, text] : output.writing)
    if (text) return no_file(flag_of(name));
  return io::SampleColumns();
}

}  // namespace orispline::cli
