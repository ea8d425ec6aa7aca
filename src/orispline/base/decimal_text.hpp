// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What stands around the digits of a number as written: ± digits · 10^exponent.
struct WrittenDecimal {
  int sign = 1;
  std::int64_t exponent = 0;  ///< of the last digit
};

/// Reads the parts of a decimal number from the front of a text.
class DecimalScanner {
 public:
  explicit DecimalScanner(std::string_view text) : rest_(text) {}

  /// Calls `use` with each digit, and gives what is around them; nothing for a text that is no number such as `-12`,
  /// `+1.5`, `.5`, `1e-9`, as a whole and without blanks.
  template <class Use>
  [[nodiscard]] std::optional<WrittenDecimal> scan(Use use) {
    WrittenDecimal written{.sign = sign()};
    int digits = take_digits(use);
    if (take('.')) {
      const int decimals = take_digits(use);
      digits += decimals;
      written.exponent = -decimals;
    }
    if (digits == 0) return std::nullopt;
    if (take('e') || take('E')) {
      const int exponent_sign = sign();
      std::int64_t exponent = 0;
      const auto grow = [&exponent](int digit) { exponent = std::min(exponent * 10 + digit, exponent_cap); };
      if (take_digits(grow) == 0) return std::nullopt;
      written.exponent += exponent_sign * exponent;
    }
    return rest_.empty() ? std::optional(written) : std::nullopt;
  }

 private:
  static constexpr std::int64_t exponent_cap = 1'000'000'000;  // farther is as far out of range

  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// -1 after a minus sign, else 1.
  int sign() {
    if (take('-')) return -1;
    take('+');
    return 1;
  }
  /// Calls `use` with each digit; gives their number.
  template <class Use>
  int take_digits(Use use) {
    std::size_t count = 0;
    for (; count < rest_.size() && '0' <= rest_[count] && rest_[count] <= '9'; ++count) use(rest_[count] - '0');
    rest_.remove_prefix(count);
    return static_cast<int>(count);
  }

  std::string_view rest_;
};

}}  // namespace orispline
