// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

#include "options/summary_options.hpp"
#include "output/gathered_output.hpp"
#include "output/json_document.hpp"
#include "output/standard_output.hpp"

// What a command that writes a file says at its end.

namespace orispline::cli {

/// Where an output goes, for people: its path, or `standard output`.
[[nodiscard]] std::string destination(const std::string& output);

/// What a task made of an input, and where it was written.
template <class Outcome>
struct Written {
  std::string input, output;
  std::string what;  ///< is in the output: `keys`; empty: what the summary is about
  Outcome outcome;
};
template <class Outcome>
Written(std::string, std::string, std::string_view, Outcome) -> Written<Outcome>;

template <class Outcome>
[[nodiscard]] std::string text_of(const Written<Outcome>& written) {
  return summary_of(written.outcome) + written.what + (written.what.empty() ? "" : " ") +
         formatted("written to {}\n", destination(written.output));
}
template <class Outcome>
requires requires(const Outcome& outcome) { line_of(outcome); }
[[nodiscard]] std::string line_of(const Written<Outcome>& written) {
  return formatted("{}: {}", printable(written.output), line_of(written.outcome));
}
template <class Outcome>
[[nodiscard]] Json json_of(const Written<Outcome>& written) {
  Json json{{"input", written.input}, {"output", written.output}};
  json.update(document_of(written.outcome));
  return json;
}

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
