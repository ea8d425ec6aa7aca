// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Bytes as text of letters, digits, `+` and `/`, filled up with `=` (RFC 4648, section 4).
[[nodiscard]] std::string base64_of(std::string_view bytes);

/// The bytes again; the `=` may be left out. Nothing for text that is not base64.
[[nodiscard]] std::optional<std::string> bytes_from_base64(std::string_view text);

}}  // namespace orispline
