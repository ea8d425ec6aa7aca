// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace orispline::report {

/// How many characters a UTF-8 text has; not its bytes.
[[nodiscard]] inline std::size_t characters(std::string_view utf8) {
  const auto begins_one = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(utf8, begins_one));
}

}  // namespace orispline::report
