// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "options/smoothness.hpp"
#include "output/report_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline smooth`, as typed.
struct SmoothOptions {
  InputOptions input;
  SmoothnessOptions smoothness;
  std::optional<std::string> rate;  ///< of samples
  OutputOptions output;
  ReportOptions report;
  SummaryOptions summary;
};

/// A noisy recording in, smooth keys with rates, or samples, out.
[[nodiscard]] Expected<void> smooth(const SmoothOptions& options);

}  // namespace orispline::cli
