// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace orispline::fuzz {

/// Whether a text is one value of JSON (RFC 8259), which knows neither NaN nor infinity.
class JsonText {
 public:
  [[nodiscard]] static bool is_whole(std::string_view text) {
    JsonText json(text);
    return json.value(most_levels) && (json.blanks(), json.text_.empty());
  }

 private:
  static constexpr int most_levels = 64;

  explicit JsonText(std::string_view text) : text_(text) {}

  void blanks() {
    while (!text_.empty() && std::string_view(" \t\r\n").find(text_.front()) != std::string_view::npos)
      text_.remove_prefix(1);
  }
  bool word(std::string_view wanted) {
    if (!text_.starts_with(wanted)) return false;
    text_.remove_prefix(wanted.size());
    return true;
  }
  bool mark(char wanted) { return blanks(), word({&wanted, 1}); }

  bool value(int levels) {
    if (levels == 0) return false;
    blanks();
    if (mark('{')) return list('}', [&] { return blanks(), string() && mark(':') && value(levels - 1); });
    if (mark('[')) return list(']', [&] { return value(levels - 1); });
    return string() || number() || word("true") || word("false") || word("null");
  }
  bool list(char end, auto element) {
    if (mark(end)) return true;
    do
      if (!element()) return false;
    while (mark(','));
    return mark(end);
  }
  bool string() {
    if (!word("\"")) return false;
    while (!text_.empty()) {
      const char c = text_.front();
      text_.remove_prefix(1);
      if (c == '"') return true;
      if (static_cast<unsigned char>(c) < 0x20 || (c == '\\' && !escape())) return false;
    }
    return false;
  }
  bool escape() {
    for (const char* plain : {"\"", "\\", "/", "b", "f", "n", "r", "t"})
      if (word(plain)) return true;
    if (!word("u")) return false;
    for (int i = 0; i < 4; ++i) {
      if (text_.empty() || !std::isxdigit(static_cast<unsigned char>(text_.front()))) return false;
      text_.remove_prefix(1);
    }
    return true;
  }
  bool digits() {
    const std::size_t count = std::min(text_.find_first_not_of("0123456789"), text_.size());
    text_.remove_prefix(count);
    return count > 0;
  }
  bool number() {
    word("-");
    if (!word("0") && !digits()) return false;
    if (word(".") && !digits()) return false;
    if (!word("e") && !word("E")) return true;
    if (!word("+")) word("-");
    return digits();
  }

  std::string_view text_;
};

}  // namespace orispline::fuzz
