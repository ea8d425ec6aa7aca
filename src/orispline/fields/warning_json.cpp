// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/warning_json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Json warnings_json(std::span<const Warning> warnings) {
  Json list = Json::array();
  for (const Warning& warning : warnings) {
    Json json{{"code", warning.code}, {"message", warning.message}};
    if (warning.where.line) json["line"] = *warning.where.line;
    if (warning.where.key) json["key"] = *warning.where.key;
    for (const auto& [name, number] : warning.numbers) json[name] = number;
    list.push_back(std::move(json));
  }
  return list;
}

}}  // namespace orispline
