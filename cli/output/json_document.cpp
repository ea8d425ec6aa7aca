// SPDX-License-Identifier: Apache-2.0
#include "output/json_document.hpp"

#include <nlohmann/json.hpp>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

using Nlohmann = nlohmann::ordered_json;

Nlohmann written(const Json& json);

struct Writing {
  Nlohmann operator()(const Json::Array& values) const {
    Nlohmann list = Nlohmann::array();
    for (const Json& value : values) list.push_back(written(value));
    return list;
  }
  Nlohmann operator()(const Json::Object& members) const {
    Nlohmann object = Nlohmann::object();
    for (const auto& [name, value] : members) object[name] = written(value);
    return object;
  }
  Nlohmann operator()(const auto& value) const { return value; }
};

Nlohmann written(const Json& json) { return std::visit(Writing{}, json.value()); }

/// DEL and C1 as `\u009b`, for terminals obey these too; nlohmann's escapes C0 alone. `json` is UTF-8.
std::string with_controls_escaped(std::string_view json) {
  std::string text;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(json[k]); };
    const bool is_c1 = byte(i) == 0xC2 && byte(i + 1) < 0xA0;
    if (is_c1) text += formatted("\\u{:04x}", byte(++i));
    else if (byte(i) == 0x7F) text += "\\u007f";
    else text += json[i];
  }
  return text;
}

}  // namespace

std::string document(const Json& json) {
  return with_controls_escaped(written(json).dump(2, ' ', false, Nlohmann::error_handler_t::replace)) + "\n";
}

}  // namespace orispline::cli
