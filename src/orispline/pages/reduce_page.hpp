// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <orispline/pages/page_head.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// The page to look at: the recording that was reduced, and the curves of all reductions, one at least, the smallest
/// first. `smoothing_time`: that the recording was smoothed with before [s].
[[nodiscard]] ORISPLINE_EXPORT report::Page reduce_page(const Track& recording, std::span<const Reduction> reductions,
                                                        const ReduceOptions& options, const PageHead& head,
                                                        std::optional<double> smoothing_time = std::nullopt);

}}}  // namespace orispline::pages
