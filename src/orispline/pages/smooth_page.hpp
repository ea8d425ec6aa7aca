// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/pages/page_head.hpp>
#include <orispline/report/page.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// The page to look at: the smoothed motion beside the recording as it was read.
[[nodiscard]] ORISPLINE_EXPORT report::Page smooth_page(const Track& recording, const Smoothing& smoothing,
                                                        const PageHead& head);

}}}  // namespace orispline::pages
