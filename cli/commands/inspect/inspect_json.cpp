// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect_report.hpp"

#include <orispline/math/degrees.hpp>

#include "options/input_options.hpp"
#include "output/findings_text.hpp"
#include "output/json_document.hpp"

namespace orispline::cli {

namespace {

/// Three members for a key: its index, its line in the file, its exact time.
void add_place(Json& json, const std::string& name, const InspectReport& report, std::size_t key) {
  json[name + "_key"] = key;
  const auto& lines = report.file.track.lines;
  json[name + "_line"] = lines.empty() ? Json(nullptr) : Json(lines[key]);
  json[name + "_time_s"] = report.time_of(key).to_string();
}

void add_statistics(Json& json, const InspectReport& report) {
  json["span_s"] = report.statistics.span;
  if (const auto& spacing = report.statistics.spacing) {
    json["spacing_min_s"] = spacing->smallest;
    json["spacing_median_s"] = spacing->median;
    json["spacing_max_s"] = spacing->largest;
    add_place(json, "spacing_max_after", report, spacing->largest_at);
  }
  if (const auto& step = report.statistics.step) {
    json["step_median_deg"] = step->median * degrees;
    json["step_max_deg"] = step->largest * degrees;
    add_place(json, "step_max_after", report, step->largest_at);
  }
  json["near_180_steps"] = report.statistics.near_half_turns.size();
  json["near_180_after_keys"] = report.statistics.near_half_turns;
}

void add_jump(Json& json, const std::string& name, const std::string& unit, const RateJump& jump) {
  json[name + "_jump_max_" + unit] = jump.largest;
  json[name + "_jump_max_relative"] = jump.relative;
  json[name + "_jump_max_key"] = jump.key;
  json[name + "_max_" + unit] = jump.magnitude;
}

void add_shape_jump(Json& method, const std::string& name, const std::string& unit, const ShapeJump& jump) {
  method[name + "_jump_max" + unit] = jump.largest;
  method[name + "_jump_max_relative"] = jump.relative;
  method[name + "_jump_max_key"] = jump.key;
}

void add_shape(Json& method, const ShapeContinuity& shape) {
  const auto order = shape.order(), order_in_motion = shape.order_in_motion();
  method["shape_order"] = order ? Json(*order) : Json(nullptr);
  method["shape_order_in_motion"] = order_in_motion ? Json(*order_in_motion) : Json(nullptr);
  method["rests_at_keys"] = shape.rests;
  add_shape_jump(method, "direction", "", shape.direction);
  add_shape_jump(method, "curvature", "_per_rad", shape.curvature);
  add_shape_jump(method, "curvature_rate", "_per_rad2", shape.curvature_rate);
}

Json methods(const InspectReport& report) {
  Json methods = Json::array();
  for (const auto& [name, continuity, shape, findings] : report.methods) {
    Json method{{"method", name}, {"continuity_order", continuity.order()}};
    add_jump(method, "angular_velocity", "rad_s", continuity.angular_velocity);
    add_jump(method, "angular_acceleration", "rad_s2", continuity.angular_acceleration);
    add_jump(method, "angular_jerk", "rad_s3", continuity.angular_jerk);
    add_shape(method, shape);
    method["findings"] = findings_json(findings);
    methods.push_back(std::move(method));
  }
  return methods;
}

}  // namespace

std::string json_of(const InspectReport& report) {
  const std::size_t last = report.keys() - 1;
  Json json{{"file", report.file.track.name},
            {"format", report.file.format->id},
            {"keys", report.keys()},
            {"start_s", report.time_of(0).to_string()},
            {"end_s", report.time_of(last).to_string()}};
  const Recipe& recipe = report.file.track.recipe;
  json["for_method"] = recipe.method.empty() ? Json(nullptr) : Json(recipe.method);
  json["signs"] = word_of(sign_choices, recipe.signs);
  add_statistics(json, report);
  json["sign_flips"] = report.keyframes.sign_flips;
  json["non_unit_keys"] = report.keyframes.non_unit_keys;
  json["wrong_norm_keys"] = report.wrong_norms;
  json["norm_error_max"] = report.keyframes.largest_norm_error;
  json["duplicate_times"] = report.file.repairs.duplicates_dropped;
  json["out_of_order_rows"] = report.file.repairs.rows_moved;
  json["invalid_rows"] = report.file.repairs.invalid_dropped;
  json["defect"] = report.defect ? Json(*report.defect) : Json(nullptr);
  json["methods"] = methods(report);
  return document(json);
}

}  // namespace orispline::cli
