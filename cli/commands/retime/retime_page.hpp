// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/retime/retime_report.hpp"
#include "output/report_file.hpp"

namespace orispline::cli {

/// The page to look at: the motion as it was and as it is slowed, with the limits.
[[nodiscard]] report::Page page_of(const RetimeReport& report, const Track& before, const ReportOptions& options);

}  // namespace orispline::cli
