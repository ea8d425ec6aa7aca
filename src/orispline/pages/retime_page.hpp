// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/pages/page_head.hpp>
#include <orispline/report/page.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// The page to look at: the motion as it was and as it is slowed, with the limits.
[[nodiscard]] ORISPLINE_EXPORT report::Page retime_page(const Track& before, const Retiming& retiming,
                                                        const MotionLimits& limits, const PageHead& head);

}}}  // namespace orispline::pages
