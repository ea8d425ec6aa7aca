// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/smooth/smooth_report.hpp"
#include "output/report_file.hpp"

namespace orispline::cli {

/// The page to look at: the smoothed motion beside the recording as it was read.
[[nodiscard]] report::Page page_of(const SmoothReport& report, const ReportOptions& options);

}  // namespace orispline::cli
