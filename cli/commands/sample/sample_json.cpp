// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_report.hpp"

#include <orispline/math/degrees.hpp>

#include "commands/sample/sample.hpp"
#include "output/findings_text.hpp"
#include "output/json_document.hpp"
#include "output/repairs_json.hpp"

namespace orispline::cli {

namespace {

Json truth(const TruthReport& truth) {
  const DistanceStatistics& d = truth.distance;
  return {{"file", truth.path},
          {"compared", d.count},
          {"distance_rms_deg", d.rms * degrees},
          {"distance_mean_deg", d.mean * degrees},
          {"distance_max_deg", d.largest * degrees},
          {"distance_max_time_s", truth.largest_time.to_string()}};
}

/// The names of the columns, where they may be many.
Json columns_of(const io::SampleColumns& columns) {
  return columns.format->holds.rates ? Json(io::column_names(columns)) : Json(nullptr);
}

}  // namespace

Json json_of(const SampleReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"output_format", report.columns.format->id},
            {"output_orientation", word_of(orientation_choices, report.columns.form.representation)},
            {"method", report.method},
            {"method_text", report.method_text},
            {"keys", report.keys},
            {"start_s", report.start.to_string()},
            {"end_s", report.end.to_string()},
            {"samples", report.samples},
            {"held_samples", report.held_samples},
            {"columns", columns_of(report.columns)},
            {"derivatives", report.columns.derivatives},
            {"frame", word_of(frame_choices, report.columns.frame)},
            {"sign_flips", report.keyframes.sign_flips},
            {"non_unit_keys", report.keyframes.non_unit_keys}};
  add_repairs(json, report.repairs);
  json["findings"] = findings_json(report.findings);
  json["band"] = report.band ? Json(*report.band) : Json(nullptr);
  json["truth"] = report.truth ? truth(*report.truth) : Json(nullptr);
  return json;
}

}  // namespace orispline::cli
