// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace orispline::io {

/// Writes numbers as the shortest text that reads back as the same double: `0.1`, `1e-05`, `12`.
class ShortestText {
 public:
  static constexpr std::size_t longest = 24;  ///< [characters] `-1.2345678901234567e-308`

  /// The text of a finite number, valid until the next call.
  [[nodiscard]] std::string_view of(double value) { return {text_.data(), write(text_.data(), value)}; }
  /// Writes the text of a finite number to where there is room for `longest` characters; gives its end.
  static char* write(char* to, double value);

 private:
  std::array<char, longest> text_;
};

}  // namespace orispline::io
