// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

#include <algorithm>

#include "input_options.hpp"
#include "json_document.hpp"
#include "quantity.hpp"
#include "sample.hpp"
#include "tune.hpp"

namespace orispline::cli {
namespace {

Json parameters_of(const FamilyInfo& family) {
  Json parameters = Json::array();
  for (const Parameter& p : family.parameters)
    parameters.push_back({{"name", p.name},
                          {"default", p.initial},
                          {"min", p.lowest},
                          {"max", p.highest},
                          {"per_key", p.per_key},
                          {"ghosts", p.ghosts}});
  return parameters;
}

Json choices_of(const FamilyInfo& family) {
  Json choices = Json::array();
  for (const auto& [name, words] : family.choices)
    choices.push_back({{"name", name}, {"default", words.front()}, {"words", words}});
  return choices;
}

Json ends_of(const FamilyInfo& family) {
  Json ends = Json::array();
  for (const EndRule rule : family.ends) ends.push_back(name_of(rule));
  return ends;
}

Json method(const FamilyInfo& family) {
  return {{"name", family.name},
          {"title", family.title},
          {"source", family.source},
          {"interpolates", family.interpolates},
          {"continuity_uniform", family.continuity_uniform},
          {"continuity_uneven", family.continuity_uneven},
          {"keeps_constant_rate_uniform", family.keeps_constant_rate_uniform},
          {"keeps_constant_rate_uneven", family.keeps_constant_rate_uneven},
          {"support_keys", family.support_keys == all_keys ? Json(nullptr) : Json(family.support_keys)},
          {"min_keys", family.min_keys},
          {"closes", family.closes},
          {"rate_orders", family.rate_orders},
          {"parameters", parameters_of(family)},
          {"choices", choices_of(family)},
          {"ends", ends_of(family)}};
}

/// The word by which an option chooses a value.
template <class T, std::size_t N>
std::string_view word_of(const std::array<Choice<T>, N>& choices, T value) {
  return std::ranges::find(choices, value, &Choice<T>::second)->first;
}

/// Three members for a key: its index, its line in the file, its exact time.
void add_place(Json& json, const std::string& name, const InspectReport& report, std::size_t key) {
  json[name + "_key"] = key;
  json[name + "_line"] = report.file.lines[key];
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

Json methods(const InspectReport& report) {
  Json methods = Json::array();
  for (const auto& [name, continuity] : report.methods) {
    Json method{{"method", name}, {"continuity_order", continuity.order()}};
    add_jump(method, "angular_velocity", "rad_s", continuity.angular_velocity);
    add_jump(method, "angular_acceleration", "rad_s2", continuity.angular_acceleration);
    add_jump(method, "angular_jerk", "rad_s3", continuity.angular_jerk);
    methods.push_back(std::move(method));
  }
  return methods;
}

void add_repairs(Json& json, const io::RepairReport& repairs) {
  json["duplicates_dropped"] = repairs.duplicates_dropped;
  json["invalid_dropped"] = repairs.invalid_dropped;
  json["rows_moved"] = repairs.rows_moved;
}

Json truth(const TruthReport& truth) {
  const DistanceStatistics& d = truth.distance;
  return {{"file", truth.path},
          {"compared", d.count},
          {"distance_rms_deg", d.rms * degrees},
          {"distance_mean_deg", d.mean * degrees},
          {"distance_max_deg", d.largest * degrees},
          {"distance_max_time_s", truth.largest_time.to_string()}};
}

Json table(const report::Table& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const report::Column& column : table.columns) columns.push_back(column.name);
  for (const auto& row : table.rows) {
    Json& cells = rows.emplace_back(Json::array());
    for (const report::Cell& cell : row) std::visit([&](const auto& value) { cells.push_back(value); }, cell);
  }
  return {{"title", table.title}, {"columns", columns}, {"rows", rows}, {"notes", table.notes}};
}

/// The names of the columns, where they may be many.
Json columns_of(const io::SampleColumns& columns) {
  return io::holds_all_columns(columns.format) ? Json(io::column_names(columns)) : Json(nullptr);
}

}  // namespace

std::string json_of(std::span<const FamilyInfo> families) {
  Json list = Json::array();
  for (const FamilyInfo& family : families) list.push_back(method(family));
  return document(list);
}

std::string json_of(const InspectReport& report) {
  const std::size_t last = report.times.size() - 1;
  Json json{{"file", report.file.path},
            {"format", word_of(format_choices, report.file.format)},
            {"keys", report.times.size()},
            {"start_s", report.time_of(0).to_string()},
            {"end_s", report.time_of(last).to_string()}};
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

std::string json_of(const SampleReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"output_format", word_of(output_format_choices, report.columns.format)},
            {"output_orientation", word_of(orientation_choices, report.columns.form.representation)},
            {"method", report.method},
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
  json["truth"] = report.truth ? truth(*report.truth) : Json(nullptr);
  return document(json);
}

std::string json_of(const ConvertReport& report) {
  Json json{{"input", report.input},
            {"input_format", word_of(format_choices, report.input_format)},
            {"output", report.output},
            {"output_format", word_of(output_format_choices, report.output_format)},
            {"keys", report.keys},
            {"start_s", report.start.to_string()},
            {"end_s", report.end.to_string()},
            {"sign_flips", report.keyframes.sign_flips},
            {"non_unit_keys", report.keyframes.non_unit_keys}};
  add_repairs(json, report.repairs);
  json["dropped_columns"] = report.dropped_columns;
  return document(json);
}

std::string json_of(const CompareReport& report) {
  Json list = Json::array();
  const auto figures = compare_figures(report);
  for (const ComparedMethod& method : report.methods) {
    const KeySet& keys = report.data.key_sets[method.key_set];
    Json json{{"method", method.label},
              {"keep_every", keys.decimation ? Json(keys.decimation->keep_every) : Json(nullptr)},
              {"keys", keys.keys.size()},
              {"samples", keys.compared}};
    for (const CompareFigure& figure : figures) {
      const auto value = method.measures ? figure.value(*method.measures, report.data) : std::nullopt;
      const bool whole = figure.id == "continuity";
      json[std::string(figure.id)] = !value ? Json(nullptr) : whole ? Json(static_cast<int>(*value)) : Json(*value);
    }
    json["error"] = method.measures ? Json(nullptr) : Json(describe(method.measures.error()));
    list.push_back(std::move(json));
  }
  return document(list);
}

std::string json_of(const TuneReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.method},
            {"objective", word_of(objective_choices, report.objective)},
            {"unit", unit_of(report.objective)},
            {"keys", report.times.size()},
            {"energy_before", report.tuning.energy_before},
            {"energy_after", report.tuning.energy_after},
            {"iterations", report.tuning.iterations},
            {"stationarity", report.tuning.stationarity},
            {"t", report.times}};
  for (const std::string& name : report.tuning.parameters)
    json[name] = report.tuning.options.parameters.find(name)->second;
  return document(json);
}

std::string json_of(std::span<const Experiment> experiments) {
  Json list = Json::array();
  for (const Experiment& experiment : experiments)
    list.push_back(Json{{"experiment", experiment.name}, {"title", experiment.title}});
  return document(list);
}

std::string json_of(const std::vector<ExperimentReport>& reports) {
  Json list = Json::array();
  for (const ExperimentReport& report : reports) {
    Json tables = Json::array();
    for (const report::Table& t : report.findings.tables) tables.push_back(table(t));
    list.push_back(Json{
        {"experiment", report.name}, {"title", report.title}, {"tables", tables}, {"pictures", report.picture_files}});
  }
  return document(list);
}

}  // namespace orispline::cli
