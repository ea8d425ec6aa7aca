// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

__extension__ typedef __int128 Integer;  ///< holds 38 decimal digits

inline constexpr auto powers_of_ten = [] {
  std::array<Integer, 39> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

[[nodiscard]] constexpr Integer integer_power_of_ten(int exponent) {
  return powers_of_ten[static_cast<std::size_t>(exponent)];
}

[[nodiscard]] constexpr std::uint64_t high_half(Integer value) { return static_cast<std::uint64_t>(value >> 64); }
[[nodiscard]] constexpr std::uint64_t low_half(Integer value) { return static_cast<std::uint64_t>(value); }

/// Number of decimal digits of a number that is not negative; 0 for 0.
[[nodiscard]] constexpr int digits_of(Integer size) {
  const auto bits = high_half(size) != 0 ? 64 + std::bit_width(high_half(size)) : std::bit_width(low_half(size));
  const int digits = static_cast<int>(bits) * 1233 >> 12;  // times log10(2): the digits, or one less
  return digits + (size >= integer_power_of_ten(digits) ? 1 : 0);
}

/// The decimal digits of a whole number that is not negative, at least one.
class Digits {
 public:
  explicit Digits(Integer value);

  [[nodiscard]] std::string_view text() const noexcept { return {text_.data() + begin_, end_of_digits - begin_}; }

 private:
  static constexpr std::size_t end_of_digits = 40;

  void put(std::uint64_t value);

  std::array<char, end_of_digits> text_;
  std::size_t begin_ = end_of_digits;
};

}}  // namespace orispline
