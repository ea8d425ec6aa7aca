// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report_file.hpp"
#include "smooth_report.hpp"

namespace orispline::cli {

/// The page to look at: the smoothed motion beside the recording as it was read.
[[nodiscard]] report::Page page_of(const SmoothReport& report, const Keyframes& recording, const Keyframes& smoothed,
                                   const ReportOptions& options);

}  // namespace orispline::cli
