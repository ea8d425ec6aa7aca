// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "options/row_options.hpp"
#include "options/several_inputs.hpp"
#include "options/smoothness.hpp"
#include "output/report_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline smooth`, as typed.
struct SmoothArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< how they are read
  SmoothnessOptions smoothness;
  std::optional<std::string> gyro_file;
  RowOptions rows;  ///< of samples in the place of keys
  OutputOptions output;
  ReportOptions report;
  SummaryOptions summary;
};

/// What the files ask of each other. Error: bad_argument.
[[nodiscard]] Expected<void> check_files(const SmoothArguments& options);

/// Noisy recordings in, smooth keys with rates, or samples, out.
[[nodiscard]] Expected<void> smooth(const SmoothArguments& options);

}  // namespace orispline::cli
