// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// significand · 10^exponent without digits that are not needed: the significand does not end in a zero digit.
struct ShortestDecimal {
  std::uint64_t significand;  ///< up to 17 digits
  int exponent;
};

/// The shortest decimal that reads back as the same double, the nearest one of those. `magnitude`: finite, not
/// negative.
[[nodiscard]] ShortestDecimal shortest_decimal(double magnitude) noexcept;

inline constexpr std::size_t longest_shortest_text = 24;  ///< [characters] `-1.2345678901234567e-308`
inline constexpr std::size_t shortest_text_room = 40;     ///< [characters] that writing it may touch

/// Writes a finite number as the shortest text that reads back as the same double: `0.1`, `1e-05`, `12`; NaN as `nan`.
///
/// `to`: where there is `shortest_text_room`. Gives the end of the text.
[[nodiscard]] char* write_shortest_text(char* to, double value);

/// The finite number that the whole text is, whatever the language of the machine: `-1.5e-3`; nothing where it is none.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

}}  // namespace orispline
