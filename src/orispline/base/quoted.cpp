// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/quoted.hpp>

#include <algorithm>

#include <orispline/base/utf8.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

/// C0, DEL and C1, which is two bytes in UTF-8.
bool is_control(std::string_view character) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  return character.size() == 1 ? at(0) < 0x20u || at(0) == 0x7Fu : at(0) == 0xC2u && at(1) < 0xA0u;
}

}  // namespace

std::string printable(std::string_view text, char instead) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(bytes, 1));
    if (bytes == 0 || is_control(character)) shown += instead;
    else shown += character;
    text.remove_prefix(character.size());
  }
  return shown;
}

std::string text_of_unicode(std::string_view text) {
  std::string unicode;
  unicode.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) unicode += "\xEF\xBF\xBD";
    else unicode += text.substr(0, bytes);
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return unicode;
}

std::string in_quotes(std::string_view text, std::size_t longest) {
  const bool shortened = text.size() > longest;
  std::size_t end = std::min(text.size(), longest);
  while (shortened && end > 0 && continues_utf8(text[end])) --end;
  std::string quoted = printable(text.substr(0, end));
  quoted.insert(quoted.begin(), '\'');
  return quoted.append(shortened ? "...'" : "'");
}

}}  // namespace orispline
