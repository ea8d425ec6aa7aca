// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/compare/compare_report.hpp"
#include "output/report_file.hpp"

namespace orispline::cli {

/// The page to look at: the curves through the first set of keys, the measures on all sets.
[[nodiscard]] report::Page page_of(const CompareReport& report, const ReportOptions& options, std::size_t threads);

}  // namespace orispline::cli
