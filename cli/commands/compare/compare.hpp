// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "options/several_inputs.hpp"
#include "options/summary_options.hpp"
#include "output/report_file.hpp"

namespace orispline::cli {

/// `orispline compare`, as typed.
struct CompareArguments {
  SeveralInputs inputs;
  InputOptions input;                   ///< how they are read
  OutputOptions output;                 ///< of the table: standard output, or a file in the folder
  std::vector<std::string> keep_every;  ///< whole numbers, or lists of them with commas between them
  std::vector<std::string> blending;    ///< files of methods of the user's own
  std::vector<std::string> methods;     ///< each time one method, or a list with commas; none: all
  std::optional<std::string> random, reference, sort;
  TypedFields measured;  ///< of MeasureOptions
  bool jitter = false, tune = false, align = false, json = false, csv = false;
  SummaryOptions summary;  ///< how much is said besides
  ReportOptions report;
};

/// Of each input: says how near the curves of the methods come to a recording, how smooth they are and what they cost.
[[nodiscard]] Expected<void> compare(const CompareArguments& options);

}  // namespace orispline::cli
