// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/several_inputs.hpp"
#include "output/report_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline retime`, as typed.
struct RetimeArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< how they are read
  OutputOptions output;
  ReportOptions report;
  std::optional<std::string> method;
  MethodOptions shape;
  TypedFields retiming;  ///< of orispline::RetimeOptions
  SummaryOptions summary;
};

/// Keyframes in, the same at later times out, so that the motion stays within the limits.
[[nodiscard]] Expected<void> retime(const RetimeArguments& options);

}  // namespace orispline::cli
