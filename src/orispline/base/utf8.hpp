// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The bytes of the character that a text begins with; 0 where it is no UTF-8. Precondition: it is not empty.
[[nodiscard]] constexpr std::size_t character_bytes(std::string_view text) noexcept {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = at(0);
  if (first < 0x80) return 1;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((at(i) & 0xC0u) != 0x80u) return 0;
  const bool is_overlong = (first == 0xE0 && at(1) < 0xA0) || (first == 0xF0 && at(1) < 0x90);
  const bool is_surrogate = first == 0xED && at(1) >= 0xA0, is_beyond = first == 0xF4 && at(1) >= 0x90;
  return is_overlong || is_surrogate || is_beyond ? 0 : bytes;
}

}}  // namespace orispline
