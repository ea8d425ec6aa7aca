// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert_report.hpp"

#include <orispline/io/file_json.hpp>

#include "options/output_options.hpp"
#include "output/json_document.hpp"

namespace orispline::cli {

Json json_of(const ConvertReport& report) {
  Json json{{"input", report.input},
            {"input_format", report.input_format->id},
            {"output", report.output},
            {"output_format", report.output_format->id},
            {"keys", report.keys},
            {"start_s", report.start.to_string()},
            {"end_s", report.end.to_string()},
            {"sign_flips", report.keyframes.sign_flips},
            {"non_unit_keys", report.keyframes.non_unit_keys}};
  add_repairs(json, report.repairs);
  json["dropped_columns"] = report.dropped_columns;
  return json;
}

}  // namespace orispline::cli
