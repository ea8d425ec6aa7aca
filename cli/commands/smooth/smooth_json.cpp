// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/smooth/smooth_fields.hpp>

#include "commands/smooth/smooth_report.hpp"

namespace orispline::cli {

Json json_of(const SmoothReport& report) {
  Json json{{"input", report.recording.name},          {"output", report.output},
            {"samples", report.recording.keys.size()}, {"rows_written", report.rows},
            {"penalty", word_of(report.penalty)},      {"loss", word_of(report.loss)}};
  put(json, report.smoothing, jobs::places_of(report.recording));
  return json;
}

}  // namespace orispline::cli
