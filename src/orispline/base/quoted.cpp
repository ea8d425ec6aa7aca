// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/quoted.hpp>

#include <algorithm>

namespace orispline::inline ORISPLINE_ABI {
namespace {

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20u || c == 0x7F; }

}  // namespace

std::string in_quotes(std::string_view text, std::size_t longest) {
  const bool shortened = text.size() > longest;
  std::size_t end = std::min(text.size(), longest);
  while (shortened && end > 0 && continues_utf8(text[end])) --end;
  std::string shown(text.substr(0, end));
  std::replace_if(shown.begin(), shown.end(), is_control, '?');
  return "'" + shown + (shortened ? "...'" : "'");
}

}  // namespace orispline::inline ORISPLINE_ABI
