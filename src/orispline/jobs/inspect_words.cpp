// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

const Track& track_of(const InspectOutcome& outcome) { return *outcome.request.keys; }

/// Three members for a key: its index, its line in the file, its exact time.
void add_place(Json& json, const std::string& name, const InspectOutcome& outcome, std::size_t key) {
  json[name + "_key"] = key;
  const auto& lines = track_of(outcome).lines;
  json[name + "_line"] = lines.empty() ? Json(nullptr) : Json(lines[key]);
  json[name + "_time_s"] = track_of(outcome).time_of(key).to_string();
}

void add_statistics(Json& json, const InspectOutcome& outcome) {
  json["span_s"] = outcome.statistics.span;
  if (const auto& spacing = outcome.statistics.spacing) {
    json["spacing_min_s"] = spacing->smallest;
    json["spacing_median_s"] = spacing->median;
    json["spacing_max_s"] = spacing->largest;
    add_place(json, "spacing_max_after", outcome, spacing->largest_at);
  }
  if (const auto& step = outcome.statistics.step) {
    json["step_median_deg"] = step->median * degrees;
    json["step_max_deg"] = step->largest * degrees;
    add_place(json, "step_max_after", outcome, step->largest_at);
  }
  json["near_180_steps"] = outcome.statistics.near_half_turns.size();
  json["near_180_after_keys"] = outcome.statistics.near_half_turns;
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
  method["stands_at_keys"] = shape.stands;
  method["shape_order_hidden"] = shape.is_hidden();
  const auto [corner, key] = shape.corner();
  method["corner_max_deg"] = corner * degrees;
  method["corner_max_key"] = key;
  add_shape_jump(method, "direction", "", shape.direction);
  add_shape_jump(method, "curvature", "_per_rad", shape.curvature);
  add_shape_jump(method, "curvature_rate", "_per_rad2", shape.curvature_rate);
}

Json methods_json(const InspectOutcome& outcome) {
  Json methods = Json::array();
  for (const auto& [label, continuity, shape, findings] : outcome.methods) {
    Json method{{"method", label}, {"continuity_order", continuity.order()}};
    method["orientation_jump_max_deg"] = continuity.orientation.angle * degrees;
    if (continuity.orientation.angle > 0.0)
      add_place(method, "orientation_jump_max_after", outcome, continuity.orientation.key);
    add_jump(method, "angular_velocity", "rad_s", continuity.angular_velocity);
    add_jump(method, "angular_acceleration", "rad_s2", continuity.angular_acceleration);
    add_jump(method, "angular_jerk", "rad_s3", continuity.angular_jerk);
    add_shape(method, shape);
    method["findings"] = findings_json(findings);
    methods.push_back(std::move(method));
  }
  return methods;
}

constexpr std::size_t places_shown = 3;

/// `key 4 (line 6, 5.2 s)`
std::string place(const InspectOutcome& outcome, std::size_t key) {
  const auto& lines = track_of(outcome).lines;
  const std::string line = lines.empty() ? "" : formatted("line {}, ", lines[key]);
  const Track& track = track_of(outcome);
  return formatted("key {} ({}{})", key, line, track.time_text(track.time_of(key)));
}

std::string keys_lines(const InspectOutcome& outcome) {
  const Track& track = track_of(outcome);
  const std::size_t last = track.keys.size() - 1;
  std::string text = formatted("{}\nkeys          {}, {}, span {} s\n", printable(track.name), last + 1,
                               track.span_text(track.time_of(0), track.time_of(last)), outcome.statistics.span);
  if (const auto& spacing = outcome.statistics.spacing)
    text += formatted("spacing       min {:.6g} s, median {:.6g} s, max {:.6g} s after {}\n", spacing->smallest,
                      spacing->median, spacing->largest, place(outcome, spacing->largest_at));
  if (const auto& step = outcome.statistics.step)
    text += formatted("steps         median {:.4g}°, max {:.4g}° after {}\n", step->median * degrees,
                      step->largest * degrees, place(outcome, step->largest_at));
  return text;
}

std::string recipe_line(const Recipe& recipe) {
  if (recipe.is_empty()) return "";
  return formatted("keys for      {}{}, as line {} says\n", printable(recipe.method),
                   recipe.signs == Signs::as_given ? ", signs as given" : "", recipe.line);
}

std::string stretches_line(const InspectOutcome& outcome) {
  const auto& stretches = outcome.stretches;
  const Track& track = track_of(outcome);
  const auto& gap = track.recipe.gap;
  if (!are_in_stretches(track.keys, gap)) return "";
  std::string line = formatted("stretches     {} by ", stretches.size());
  if (gap) line += formatted("gaps longer than {} s", *gap);
  if (track.keys.data().jumps) line += gap ? " and jumps" : "jumps";
  for (std::size_t i = 1; i < std::min(stretches.size(), places_shown + 1); ++i)
    line += formatted("{} {}", i == 1 ? ", begun at" : ",", place(outcome, stretches[i].first));
  return line + (stretches.size() > places_shown + 1 ? ", …\n" : "\n");
}

std::string half_turn_line(const InspectOutcome& outcome) {
  const auto& steps = outcome.statistics.near_half_turns;
  std::string line = formatted("near 180°     {}", steps.size());
  for (std::size_t i = 0; i < std::min(steps.size(), places_shown); ++i)
    line += formatted("{} after {}", i == 0 ? ":" : ",", place(outcome, steps[i]));
  if (steps.size() > places_shown) line += ", …";
  return line + (steps.empty() ? "\n" : "; the curve may turn the wrong way there: put a key in between\n");
}

std::string quality_lines(const InspectOutcome& outcome) {
  const KeyframeReport& keyframes = outcome.keyframes;
  const KeyFaults& faults = outcome.request.faults;
  return formatted(
      "sign flips    {}\n"
      "non-unit      {}, of which {} are farther than {:g} from 1; largest error {:.3g}\n"
      "duplicates    {}\n"
      "out of order  {}\n"
      "invalid rows  {}\n",
      keyframes.sign_flips, keyframes.non_unit_keys, faults.wrong_norms, norm_error_limit, keyframes.largest_norm_error,
      faults.duplicate_times, faults.out_of_order_rows, faults.invalid_rows);
}

template <class Jump>
std::string jump_cell(const Jump& jump) {
  if (jump.relative == 0.0) return formatted("{:>10.2e}  {:>8}", jump.largest, "none");
  return formatted("{:>10.3g}  {:>8.1e}", jump.largest, jump.relative);
}

/// The first cell of a row. A longer label has a line of its own, above its numbers.
std::string label_cell(const std::string& label) {
  constexpr std::size_t width = 20;
  return label.size() < width ? formatted("{:{}}", label, width) : formatted("{}\n{:{}}", label, "", width);
}

/// Where a curve is none, or nothing.
std::string break_line(const InspectOutcome& outcome, const InspectedMethod& method) {
  const OrientationJump& jump = method.continuity.orientation;
  if (!(jump.angle > 0.0)) return "";
  if (jump.time == outcome.request.keys->keys.times()[jump.key])
    return formatted("{} jumps by {:.4g}° at {}: the segments beside it do not meet\n", method.label,
                     jump.angle * degrees, place(outcome, jump.key));
  return formatted("{} jumps by {:.4g}° between two keys, after {}; put a key in between, or take timed-c2\n",
                   method.label, jump.angle * degrees, place(outcome, jump.key));
}

std::string methods_table(const InspectOutcome& outcome) {
  if (outcome.methods.empty()) return "";
  std::string table = formatted(
      "\nLargest jumps at the keys, absolute and relative to the largest rate\n{:20}{:>5}  "
      "{:>20}  {:>20}  {:>20}\n",
      "method", "order", "ω [rad/s]", "α [rad/s²]", "jerk [rad/s³]");
  for (const auto& [label, c, shape, findings] : outcome.methods)
    table += formatted("{}{:>5}  {}  {}  {}\n", label_cell(label), formatted("C{}", c.order()),
                       jump_cell(c.angular_velocity), jump_cell(c.angular_acceleration), jump_cell(c.angular_jerk));
  for (const InspectedMethod& method : outcome.methods) table += break_line(outcome, method);
  return table;
}

std::string order_text(std::optional<int> order) { return order ? formatted("G{}", *order) : "–"; }

std::string order_cell(const ShapeContinuity& shape) {
  return order_text(shape.order()) + (shape.is_hidden() ? "?" : "");
}

/// `and 2 more` keys than the first.
std::string others(std::size_t keys) { return keys > 1 ? formatted(" and {} more", keys - 1) : ""; }

/// What a rest makes of the shape, or nothing.
std::string rest_line(const InspectOutcome& outcome, const InspectedMethod& method) {
  const ShapeContinuity& shape = method.shape;
  if (shape.rests == 0) return "";
  const auto in_motion = shape.order_in_motion();
  const std::string elsewhere = in_motion ? formatted("; at the other keys it is {}", order_text(in_motion)) : "";
  if (shape.stands > 0)
    return formatted("{} stands still beside {}{}: its shape is undefined there{}\n", method.label,
                     place(outcome, shape.first_stand), others(shape.stands), elsewhere);
  const std::string rest =
      formatted("{} rests at {}{}", method.label, place(outcome, shape.first_rest), others(shape.rests));
  if (shape.order() == 0) return formatted("{}{}\n", rest, elsewhere);
  return formatted("{} and goes on in the same direction: it is G1 there, and has no finite curvature in general{}\n",
                   rest, elsewhere);
}

/// How wide the widest corner is, or nothing.
std::string corner_line(const InspectOutcome& outcome, const InspectedMethod& method) {
  if (method.shape.order() != 0 || method.shape.is_hidden()) return "";
  const auto [corner, key] = method.shape.corner();
  return formatted("{} has a corner of {:.1f}° at {}\n", method.label, corner * degrees, place(outcome, key));
}

/// Where the rates are too small for their shape, or nothing.
std::string hidden_line(const InspectOutcome& outcome, const InspectedMethod& method) {
  const ShapeContinuity& shape = method.shape;
  if (!shape.is_hidden()) return "";
  return formatted("{} is {} at least: double precision cannot tell more at {}, where it nearly rests\n", method.label,
                   order_text(shape.order()), place(outcome, shape.hidden_at));
}

std::string shapes_table(const InspectOutcome& outcome) {
  if (outcome.methods.empty()) return "";
  std::string table = formatted(
      "\nThe same of the shape, whatever the speed: how the path turns by the angle travelled\n{:20}{:>5}  "
      "{:>20}  {:>20}  {:>20}\n",
      "method", "shape", "direction", "curvature [1/rad]", "its change [1/rad²]");
  for (const auto& [label, continuity, s, findings] : outcome.methods)
    table += formatted("{}{:>5}  {}  {}  {}\n", label_cell(label), order_cell(s), jump_cell(s.direction),
                       jump_cell(s.curvature), jump_cell(s.curvature_rate));
  for (const InspectedMethod& method : outcome.methods)
    table += rest_line(outcome, method) + corner_line(outcome, method) + hidden_line(outcome, method);
  return table;
}

std::string findings_lines(const InspectOutcome& outcome) {
  std::string lines;
  for (std::size_t i = 0; i < outcome.methods.size(); ++i)
    if (const auto& [label, continuity, shape, findings] = outcome.methods[i]; findings)
      lines += formatted("\nThe keys say to {}: {}\nwhich as settings are '{}'\n", label, findings_text(*findings),
                         text_of(with_findings(outcome.request.methods[i], *findings)));
  return lines;
}

}  // namespace

Json document_of(const InspectOutcome& outcome) {
  const Track& track = track_of(outcome);
  const KeyFaults& faults = outcome.request.faults;
  Json json{{"keys", track.keys.size()},
            {"start_s", track.time_of(0).to_string()},
            {"end_s", track.time_of(track.keys.size() - 1).to_string()}};
  json["for_method"] = track.recipe.method.empty() ? Json(nullptr) : Json(track.recipe.method);
  json["signs"] = track.recipe.signs == Signs::as_given ? "as-given" : "shortest";
  json["gap_s"] = track.recipe.gap ? Json(*track.recipe.gap) : Json(nullptr);
  json["jumps"] = track.keys.data().jumps;
  json["stretches"] = outcome.stretches.size();
  add_statistics(json, outcome);
  json["sign_flips"] = outcome.keyframes.sign_flips;
  json["non_unit_keys"] = outcome.keyframes.non_unit_keys;
  json["wrong_norm_keys"] = faults.wrong_norms;
  json["norm_error_max"] = outcome.keyframes.largest_norm_error;
  json["duplicate_times"] = faults.duplicate_times;
  json["out_of_order_rows"] = faults.out_of_order_rows;
  json["invalid_rows"] = faults.invalid_rows;
  json["defect"] = faults.defect ? Json(*faults.defect) : Json(nullptr);
  json["methods"] = methods_json(outcome);
  return json;
}

std::string summary_of(const InspectOutcome& outcome) {
  std::string text = keys_lines(outcome) + recipe_line(track_of(outcome).recipe) + stretches_line(outcome) +
                     half_turn_line(outcome) + quality_lines(outcome);
  if (const auto& defect = outcome.request.faults.defect) text += formatted("defect        {}\n", *defect);
  return text + methods_table(outcome) + shapes_table(outcome) + findings_lines(outcome);
}

}}}  // namespace orispline::jobs
