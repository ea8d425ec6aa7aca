// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/reduce/reduce_report.hpp"
#include "output/report_file.hpp"

namespace orispline::cli {

/// The page to look at: the recording, and the curves of all reductions, the one that is written first.
[[nodiscard]] report::Page page_of(const ReduceReport& report, const Track& recording, const ReportOptions& options);

}  // namespace orispline::cli
