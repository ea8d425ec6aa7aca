// SPDX-License-Identifier: Apache-2.0
#include "output/summary.hpp"

#include <orispline/base/quoted.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline::cli {

std::string destination(const std::string& output) {
  return output == io::standard_stream ? "standard output" : printable(output);
}

Json json_of_warnings() {
  Json list = Json::array();
  for (const Warning& warning : warned_here()) {
    Json json{{"code", warning.code}, {"message", warning.message}};
    if (warning.where.line) json["line"] = *warning.where.line;
    if (warning.where.key) json["key"] = *warning.where.key;
    for (const auto& [name, number] : warning.numbers) json[name] = number;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace orispline::cli
