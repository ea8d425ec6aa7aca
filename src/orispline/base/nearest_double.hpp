// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The double nearest to digits · 10^exponent, halves to even; infinite where that is beyond all doubles.
///
/// Exact by whole numbers of any length, and slow: for numbers that are rare. It asks no locale, as `std::strtod` does,
/// and needs no `std::from_chars`, which some standard libraries lack for doubles.
[[nodiscard]] double nearest_double(std::string_view digits, std::int64_t exponent);

}}  // namespace orispline
