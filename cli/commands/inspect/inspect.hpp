// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/report_options.hpp"

namespace orispline::cli {

/// `orispline inspect`, as typed.
struct InspectArguments {
  InputOptions input;
  std::vector<std::string> methods;  ///< each time one method, or a list with commas
  MethodOptions shape;
  bool json = false;
  ReportOptions report;
};

/// Says what a file of keys holds, faults included, and how continuous the methods are on it.
[[nodiscard]] Expected<void> inspect(const InspectArguments& options);

}  // namespace orispline::cli
