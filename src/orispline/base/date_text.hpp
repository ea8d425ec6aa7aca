// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The UTC date and time so many seconds after 1970-01-01T00:00:00, with all decimals: `2026-03-01T10:00:00.37`. Where
/// the year has more than four digits these are seconds: `1e13 s`.
[[nodiscard]] std::string date_text(const Decimal& seconds);

}}  // namespace orispline
