// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/io/decimal.hpp>

#include "report_file.hpp"
#include "retime_report.hpp"

namespace orispline::cli {

/// The page to look at: the motion as it was and as it is slowed, with the limits.
[[nodiscard]] report::Page page_of(const RetimeReport& report, const Keyframes& keys, const io::Decimal& epoch,
                                   const ReportOptions& options);

}  // namespace orispline::cli
