// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/date_text.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/report/table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr std::string_view none = "–";
constexpr std::size_t widest_label = 28;  // characters

bool is_on(const ComparedMethod& method, std::size_t key_set) { return method.key_set == key_set && method.measures; }

std::string continuity_of(const ComparedMethod& method) {
  return method.measures ? formatted("C{}", method.measures->continuity.order()) : std::string(none);
}

/// A time [s] since 1970 with so many significant digits.
std::string date_of(double time, int digits) {
  return Decimal::parse(formatted("{:.{}g}", time, digits)).transform(date_text).value_or("");
}

/// The heading of a column; dates have no unit.
std::string_view heading_of(const CompareOutcome& outcome, const MeasureInfo& measure) {
  const bool is_date = measure.is_time && outcome.request.keys->is_dated;
  return is_date ? measure.heading.substr(0, measure.heading.find(" [")) : measure.heading;
}

report::Cell cell_of(const CompareOutcome& outcome, const MeasureInfo& measure, const ComparedMethod& method) {
  const auto value = outcome.value(measure, method);
  if (!value) return std::string(none);
  if (!measure.order.empty()) return formatted("{}{}", measure.order, *value);
  if (measure.is_time && outcome.request.keys->is_dated) return date_of(*value, measure.digits);
  return std::abs(*value) <= measure.rounding ? 0.0 : *value;
}

/// Methods that are told the rates at the keys.
std::vector<std::string> methods_with_rates(const CompareOutcome& outcome, std::size_t key_set) {
  std::vector<std::string> names;
  if (!any_given(outcome.data.key_sets[key_set].track.keys.angular_velocities())) return names;
  for (const ComparedMethod& method : outcome.methods)
    if (is_on(method, key_set) && family_of(method.candidate.method).rate_orders > 0) names.push_back(method.label);
  return names;
}

/// Methods that are told inner quaternions at the keys.
std::vector<std::string> methods_with_inner(const CompareOutcome& outcome, std::size_t key_set) {
  std::vector<std::string> names;
  const Keyframes& keys = outcome.data.key_sets[key_set].track.keys;
  if (!keys.have_inner_quaternions()) return names;
  for (const ComparedMethod& method : outcome.methods)
    if (is_on(method, key_set) && family_of(method.candidate.method).takes_inner_quaternions())
      names.push_back(method.label);
  return names;
}

/// Whether some method has more of a measure than is shown: what happens inside the segments only.
bool is_infinite_for_some(const MeasureInfo& measure, const CompareOutcome& outcome, std::size_t key_set) {
  return std::ranges::any_of(outcome.methods, [&](const ComparedMethod& method) {
    return is_on(method, key_set) && !measure.is_finite(*method.measures);
  });
}

/// Whether some curve has keys of that kind: at which it rests, or beside which it stands still.
bool has_some(const CompareOutcome& outcome, std::size_t key_set, std::size_t ShapeContinuity::*keys) {
  return std::ranges::any_of(outcome.methods, [&](const ComparedMethod& method) {
    return is_on(method, key_set) && method.measures->shape.*keys > 0;
  });
}

std::string note_on_infinite(const MeasureInfo& measure) {
  std::string orders = "C0";
  for (int order = 1; order < measure.finite_from; ++order) orders += formatted(" or C{}", order);
  return formatted("{} is integrated inside segments only; for {} methods the true value is infinite.", measure.label,
                   orders);
}

std::vector<std::string> notes_of(const CompareOutcome& outcome, std::size_t key_set,
                                  const std::vector<MeasureInfo>& measures) {
  std::vector<std::string> notes;
  for (const ComparedMethod& method : outcome.methods)
    if (method.key_set == key_set && !method.measures)
      notes.push_back(formatted("{} has no curve: {}", method.label, describe(method.measures.error())));
  if (outcome.alignment) notes.push_back(line_of(*outcome.alignment) + ".");
  if (const auto names = methods_with_rates(outcome, key_set); !names.empty())
    notes.push_back(formatted("{} took the logged rates at the keys too.", joined(names, ", ")));
  if (const auto names = methods_with_inner(outcome, key_set); !names.empty())
    notes.push_back(formatted("{} took the inner quaternions of the keys.", joined(names, ", ")));
  for (const MeasureInfo& measure : measures)
    if (is_infinite_for_some(measure, outcome, key_set)) notes.push_back(note_on_infinite(measure));
  if (has_some(outcome, key_set, &ShapeContinuity::rests))
    notes.emplace_back("Where the body rests at a key the shape is G1 at most, and G0 if the path has a corner there.");
  if (has_some(outcome, key_set, &ShapeContinuity::stands))
    notes.emplace_back("The shape is undefined (–) where the body stands still beside a key.");
  if (outcome.request.measured.leave_out == LeaveOut::yes)
    notes.emplace_back("Left out: an estimate of the error from the keys alone; it is not fit for choosing a method.");
  return notes;
}

report::Table table_of(const CompareOutcome& outcome, std::size_t key_set) {
  report::Table table{.title = title_of(outcome, key_set),
                      .columns = {{.name = "method", .widest = widest_label}, {"order"}}};
  std::vector<MeasureInfo> measures = outcome.measures();
  std::erase_if(measures, [](const MeasureInfo& measure) { return measure.heading.empty(); });
  for (const MeasureInfo& measure : measures)
    table.columns.push_back({.name = std::string(heading_of(outcome, measure)),
                             .digits = measure.digits,
                             .rank = measure.word == outcome.request.sort ? 0 : measure.rank});
  for (const ComparedMethod& method : outcome.methods) {
    if (method.key_set != key_set) continue;
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{method.label, continuity_of(method)});
    for (const MeasureInfo& measure : measures) row.push_back(cell_of(outcome, measure, method));
  }
  table.notes = notes_of(outcome, key_set, measures);
  return table;
}

/// A cell of a CSV, in quotes where it needs them.
std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + "\"";
}

}  // namespace

Json document_of(const CompareOutcome& outcome) {
  Json list = Json::array();
  const auto measures = outcome.measures();
  for (const ComparedMethod& method : outcome.methods) {
    const ComparedKeys& keys = outcome.data.key_sets[method.key_set];
    Json json{{"method", method.label},
              {"keep_every", keys.decimation ? Json(keys.decimation->keep_every) : Json(nullptr)},
              {"keys", keys.track.keys.size()},
              {"samples", keys.compared}};
    for (const MeasureInfo& measure : measures) {
      const auto value = outcome.value(measure, method);
      json[measure.id] = !value                   ? Json(nullptr)
                         : !measure.order.empty() ? Json(static_cast<int>(*value))
                                                  : Json(*value);
    }
    json["error"] = method.measures ? Json(nullptr) : Json(describe(method.measures.error()));
    list.push_back(std::move(json));
  }
  return list;
}

std::string csv_of(const CompareOutcome& outcome) {
  const std::vector<MeasureInfo> measures = outcome.measures();
  std::string text = "method,keep_every,keys,samples";
  for (const MeasureInfo& measure : measures) text += formatted(",{}", measure.id);
  text += ",error\n";
  for (const ComparedMethod& method : outcome.methods) {
    const ComparedKeys& keys = outcome.data.key_sets[method.key_set];
    text += formatted("{},{},{},{}", csv_cell(method.label),
                      keys.decimation ? std::to_string(keys.decimation->keep_every) : "", keys.track.keys.size(),
                      keys.compared);
    for (const MeasureInfo& measure : measures) {
      const auto value = outcome.value(measure, method);
      text += value ? formatted(",{}", *value) : ",";
    }
    text += "," + (method.measures ? "" : csv_cell(describe(method.measures.error()))) + "\n";
  }
  return text;
}

std::vector<report::Table> tables_of(const CompareOutcome& outcome) {
  std::vector<report::Table> tables;
  for (std::size_t i = 0; i < outcome.data.key_sets.size(); ++i) tables.push_back(table_of(outcome, i));
  return tables;
}

std::string summary_of(const CompareOutcome& outcome) {
  std::string text;
  for (const report::Table& table : tables_of(outcome)) text.append(text.empty() ? "" : "\n").append(text_of(table));
  return text;
}

std::string line_of(const CompareOutcome& outcome) {
  const auto measures = outcome.measures();
  const auto sorted_by = std::ranges::find(measures, outcome.request.sort, &MeasureInfo::word);
  std::string line;
  for (std::size_t i = 0; i < outcome.data.key_sets.size(); ++i) {
    const auto best = std::ranges::find(outcome.methods, i, &ComparedMethod::key_set);
    const auto value = outcome.value(*sorted_by, *best);
    const auto& decimation = outcome.data.key_sets[i].decimation;
    line += formatted("{}{}{}", line.empty() ? "" : ", ", best->label, decimation ? " at " + name_of(*decimation) : "");
    if (value) line += formatted(" ({:.4g} {})", *value, sorted_by->unit);
  }
  return "best by " + outcome.request.sort + ": " + line;
}

std::string title_of(const CompareOutcome& outcome, std::size_t key_set) {
  const ComparedKeys& keys = outcome.data.key_sets[key_set];
  const std::string reference = shown_name(outcome.data.reference, "a recording");
  const std::string what = keys.decimation ? formatted("{}: {} sample kept", reference, name_of(*keys.decimation))
                                           : formatted("{} against {}", shown_name(keys.track.name, "keys"), reference);
  return formatted("{}, {}, {} compared", what, counted(keys.track.keys.size(), "key"),
                   counted(keys.compared, "sample"));
}

}}}  // namespace orispline::jobs
