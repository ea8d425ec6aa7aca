// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>
#include <orispline/jobs/sample.hpp>

#include "commands/sample/sample_request.hpp"
#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline sample` did.
struct SampleReport {
  jobs::SampleOutcome outcome{};
  std::string input{}, output{};
  io::RepairReport repairs{};
  io::SampleColumns columns{};
  bool keys_held = false;  ///< all at once, in memory
};

/// Says of samples without a plain row what became of them.
void count_rows(jobs::SampleOutcome& outcome, const SampleRequest& request, const RowCounts& counts);

/// A few lines for people.
[[nodiscard]] std::string text_of(const SampleReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const SampleReport& report);

/// The JSON document, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const SampleReport& report);

}  // namespace orispline::cli
