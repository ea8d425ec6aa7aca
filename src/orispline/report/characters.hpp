// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// How many characters a UTF-8 text shows: not its bytes, and no marks above letters such as that of û.
[[nodiscard]] inline std::size_t characters(std::string_view utf8) {
  const auto shows_one = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0U) == 0x80U, is_mark = byte == 0xCCU;  // U+0300 to U+033F
    return !continues && !is_mark;
  };
  return static_cast<std::size_t>(std::ranges::count_if(utf8, shows_one));
}

}}}  // namespace orispline::report
