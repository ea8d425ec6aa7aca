// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/base/warning.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// As documents list them: `code` and `message`, `line` and `key` where they have a place, and the numbers of the
/// message by their names.
[[nodiscard]] ORISPLINE_EXPORT Json warnings_json(std::span<const Warning> warnings);

}}  // namespace orispline
