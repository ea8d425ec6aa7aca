// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/base/expected.hpp>

#include "options/summary_options.hpp"
#include "output/gathered_output.hpp"
#include "output/json_document.hpp"
#include "output/standard_output.hpp"

// What a command that writes a file says at its end.

namespace orispline::cli {

/// Where an output goes, for people: its path, or `standard output`.
[[nodiscard]] std::string destination(const std::string& output);

/// The warnings so far, of the input that this thread works on.
[[nodiscard]] Json json_of_warnings();

/// The report as JSON on standard output, as text on standard error, or nowhere; of several inputs each has one line.
/// Error: bad_access.
template <class Report>
[[nodiscard]] Expected<void> summarise(const SummaryOptions& options, const Report& report) {
  if (options.json) {
    Json json = json_of(report);
    json["warnings"] = json_of_warnings();
    return print_document(document(json));
  }
  if (options.quiet) return {};
  if constexpr (requires { line_of(report); })
    if (gathered_here()) return tell(line_of(report) + "\n"), Expected<void>();
  tell(text_of(report));
  return {};
}

}  // namespace orispline::cli
