// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/fields/json.hpp>

#include "options/file_places.hpp"
#include "options/output_options.hpp"
#include "options/summary_options.hpp"
#include "output/json_document.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

// Of commands that print what they found, unless -o names a file for what they made.

namespace orispline::cli {

[[nodiscard]] inline bool writes_file(const OutputOptions& output) { return !output.path.empty(); }

/// What such a file holds: in the summary, and in a sentence.
struct MadeOutput {
  std::string_view name, whole_name;  ///< `keys`, `the aligned keys`
};

/// The columns of the file; none where there is no file. Error (bad_argument): options of a file without one, or a file
/// that is one of the others.
[[nodiscard]] Expected<io::SampleColumns> columns_of_made(const OutputOptions& output, const SummaryOptions& summary,
                                                          const MadeOutput& made, const std::vector<OtherFile>& others);

/// Prints the summary, or the document behind the names of the inputs.
template <class Outcome>
[[nodiscard]] Expected<void> print_found(const SummaryOptions& options, const Outcome& outcome, Json inputs) {
  if (!options.json) return print_document(summary_of(outcome));
  inputs.update(document_of(outcome));
  inputs["warnings"] = json_of_warnings();
  return print_document(document(inputs));
}

}  // namespace orispline::cli
