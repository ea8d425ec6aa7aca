// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/decimal_digits.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace orispline { inline namespace ORISPLINE_ABI {

Digits::Digits(Integer value) {
  constexpr int piece = 18;  // digits that 64 bits hold
  for (; high_half(value) != 0; value /= integer_power_of_ten(piece)) {
    const std::size_t begin = begin_ - piece;
    put(low_half(value % integer_power_of_ten(piece)));
    while (begin_ > begin) text_[--begin_] = '0';
  }
  put(low_half(value));
}

/// Puts a number before the digits that are there.
void Digits::put(std::uint64_t value) {
  const fmt::format_int digits(value);
  begin_ -= digits.size();
  std::copy_n(digits.data(), digits.size(), text_.data() + begin_);
}

}}  // namespace orispline
