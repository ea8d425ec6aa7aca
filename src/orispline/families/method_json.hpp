// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/family.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What methods say about themselves, an object each; described in docs/inspect-json.md.
[[nodiscard]] ORISPLINE_EXPORT Json methods_json(std::span<const FamilyInfo> families);

}}  // namespace orispline
