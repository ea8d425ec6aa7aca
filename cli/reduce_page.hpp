// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reduce_report.hpp"
#include "report_file.hpp"

namespace orispline::cli {

/// The page to look at: the recording, and the curves of all reductions, the one that is written first.
[[nodiscard]] report::Page page_of(const ReduceReport& report, const Keyframes& recording, const io::Decimal& epoch,
                                   const ReportOptions& options);

}  // namespace orispline::cli
