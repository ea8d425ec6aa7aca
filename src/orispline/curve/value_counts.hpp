// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether every parameter that is given has one value or one for each key, or as many as it takes else, as settle()
/// wants it too. Error: bad_argument.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_value_counts(const FamilyInfo& family, const CurveOptions& options,
                                                                 std::size_t keys);

}}  // namespace orispline
