// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_document.hpp>

#include <iterator>

#include <fmt/format.h>

#include <orispline/base/expect.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

std::string text_json(std::string_view text) {
  std::string json = "\"";
  for (const char c : text_of_unicode(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || c == '"' || c == '\\' || c == '<') fmt::format_to(std::back_inserter(json), "\\u{:04x}", code);
    else json += c;
  }
  return json + '"';
}

std::string page_with(std::span<const std::string_view> pieces, std::string_view marker, std::string_view document) {
  std::string html;
  for (const std::string_view piece : pieces) html += piece;
  const std::size_t place = html.find(marker);
  ORISPLINE_EXPECT(place != std::string::npos);
  return html.replace(place, marker.size(), document);
}

}}}  // namespace orispline::report
