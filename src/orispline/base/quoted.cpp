// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/quoted.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20u || c == 0x7F; }
bool leads_c1(char c) { return c == '\xC2'; }
bool ends_c1(char c) { return static_cast<unsigned char>(c) >= 0x80u && static_cast<unsigned char>(c) < 0xA0u; }

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool c1 = leads_c1(text[i]) && i + 1 < text.size() && ends_c1(text[i + 1]);
    shown += c1 || is_control(text[i]) ? '?' : text[i];
    if (c1) ++i;
  }
  return shown;
}

std::string in_quotes(std::string_view text, std::size_t longest) {
  const bool shortened = text.size() > longest;
  std::size_t end = std::min(text.size(), longest);
  while (shortened && end > 0 && continues_utf8(text[end])) --end;
  return "'" + printable(text.substr(0, end)) + (shortened ? "...'" : "'");
}

}}  // namespace orispline
