// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/families/auto_rates.hpp>
#include <orispline/families/measured.hpp>

namespace orispline::inline ORISPLINE_ABI::families {

/// What the keys say, or the settings instead. At least `least_window` keys.
[[nodiscard]] KeyFindings findings_of(const Keyframes& keys, Through through, const FamilySettings& settings);

}  // namespace orispline::inline ORISPLINE_ABI::families
