// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/retime/retime.hpp>

#include "input_options.hpp"
#include "method_options.hpp"
#include "output_options.hpp"
#include "report_file.hpp"
#include "summary.hpp"

namespace orispline::cli {

/// `orispline retime`, as typed.
struct RetimeOptions {
  InputOptions input;
  OutputOptions output;
  ReportOptions report;
  std::string method{default_method};
  std::optional<std::string> rate, acceleration, torque, inertia;
  bool per_interval = false;
  SummaryOptions summary;
};

/// Keyframes in, the same at later times out, so that the motion stays within the limits.
[[nodiscard]] Expected<void> retime(const RetimeOptions& options);

}  // namespace orispline::cli
