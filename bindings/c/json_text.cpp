// SPDX-License-Identifier: Apache-2.0
#include "json_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/utf8.hpp>

namespace orispline::c {

namespace {

/// U+FFFD, for what is no UTF-8, as names of files may be.
constexpr std::string_view replacement = "\xEF\xBF\xBD";

struct Writing {
  std::string& to;

  void operator()(std::nullptr_t) const { to += "null"; }
  void operator()(bool value) const { to += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { to += formatted("{}", value); }
  void operator()(std::uint64_t value) const { to += formatted("{}", value); }
  void operator()(double value) const {
    std::array<char, shortest_text_room> room;
    if (std::isfinite(value)) to.append(room.data(), write_shortest_text(room.data(), value));
    else to += "null";
  }
  void operator()(std::string_view text) const {
    to += '"';
    while (!text.empty()) {
      const std::size_t bytes = character_bytes(text);
      const auto code = static_cast<unsigned char>(text.front());
      if (bytes == 0) to += replacement;
      else if (code == '"' || code == '\\') to.append(1, '\\').append(1, text.front());
      else if (code < 0x20 || code == 0x7F) to += formatted("\\u{:04x}", code);
      else to += text.substr(0, bytes);
      text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    to += '"';
  }
  void operator()(const Json::Array& values) const {
    to += '[';
    for (const Json& value : values) {
      if (&value != &values.front()) to += ',';
      std::visit(*this, value.value());
    }
    to += ']';
  }
  void operator()(const Json::Object& members) const {
    to += '{';
    for (const Json::Member& member : members) {
      if (&member != &members.front()) to += ',';
      (*this)(std::string_view(member.first));
      to += ':';
      std::visit(*this, member.second.value());
    }
    to += '}';
  }
};

}  // namespace

std::string json_text(const Json& json) {
  std::string text;
  std::visit(Writing{text}, json.value());
  return text;
}

}  // namespace orispline::c
