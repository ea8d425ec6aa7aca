// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_report.hpp"

#include <orispline/fields/field_json.hpp>
#include <orispline/tune/tune_fields.hpp>

namespace orispline::cli {

Json json_of(const TuneReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.tuning.method.name},
            {"objective", word_of(report.objective)},
            {"unit", unit_of(report.objective)},
            {"keys", report.times.size()}};
  put(json, report.tuning);
  json["t"] = report.times;
  for (const std::string& name : report.tuning.parameters)
    json[name] = report.tuning.method.options.parameters.find(name)->second;
  return json;
}

}  // namespace orispline::cli
