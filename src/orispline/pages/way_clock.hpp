// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/report/page.hpp>

// Two motions along the same way at different times: when one is where the other is.

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// The times of a motion at which it is at the places of the one that the page follows, key by key. As many keys.
[[nodiscard]] report::PageClock clock_of_keys(const Keyframes& page, const Keyframes& own);

/// The same for curves with other keys, by the angle and the distance that they have travelled.
[[nodiscard]] report::PageClock clock_of_ways(const PoseCurve& page, const PoseCurve& own);

}}}  // namespace orispline::pages
