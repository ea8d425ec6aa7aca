// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// Text of a file as a message shows it: in quotes, cut after `longest` bytes, control characters replaced by `?`.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t longest = 40);

}  // namespace orispline::inline ORISPLINE_ABI
