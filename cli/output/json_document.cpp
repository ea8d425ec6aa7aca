// SPDX-License-Identifier: Apache-2.0
#include "output/json_document.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace

std::string document(const Json& json) {
  return written(json).dump(2, ' ', false, Nlohmann::error_handler_t::replace) + "\n";
}

}  // namespace orispline::cli
