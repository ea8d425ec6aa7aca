// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_report.hpp"

#include <algorithm>
#include <cmath>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/report/table.hpp>

#include "output/repairs_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view none = "–";
constexpr std::string_view not_shown = "The terminal is too narrow for these, which --csv and --json have too:";

std::string continuity_of(const ComparedMethod& method) {
  return method.measures ? formatted("C{}", method.measures->continuity.order()) : std::string(none);
}

report::Cell cell_of(const ComparedMethod& method, const MeasureInfo& measure, const ComparedData& data) {
  const auto value = value_of(measure, method, data);
  if (!value) return std::string(none);
  if (!measure.order.empty()) return formatted("{}{}", measure.order, *value);
  return std::abs(*value) <= measure.rounding ? 0.0 : *value;
}

/// Methods that are told the rates at the keys.
std::vector<std::string> methods_with_rates(const CompareReport& report, std::size_t key_set) {
  std::vector<std::string> names;
  if (!orispline::any_given(report.data.key_sets[key_set].track.keys.angular_velocities())) return names;
  for (const ComparedMethod& method : report.methods)
    if (method.key_set == key_set && method.measures &&
        find_family(method.candidate.method.name).value()->rate_orders > 0)
      names.push_back(method.label);
  return names;
}

/// Whether some method has more of a measure than is shown: what happens inside the segments only.
bool is_infinite_for_some(const MeasureInfo& measure, const CompareReport& report, std::size_t key_set) {
  return std::ranges::any_of(report.methods, [&](const ComparedMethod& method) {
    return method.key_set == key_set && method.measures && !measure.is_finite(*method.measures);
  });
}

/// Whether some curve has keys at which it has no direction.
bool rests_at_some(const CompareReport& report, std::size_t key_set) {
  return std::ranges::any_of(report.methods, [&](const ComparedMethod& method) {
    return method.key_set == key_set && method.measures && method.measures->shape.rests > 0;
  });
}

std::string note_on_infinite(const MeasureInfo& measure) {
  std::string orders = "C0";
  for (int order = 1; order < measure.finite_from; ++order) orders += formatted(" or C{}", order);
  return formatted("{} is integrated inside segments only; for {} methods the true value is infinite.", measure.label,
                   orders);
}

std::vector<std::string> notes_of(const CompareReport& report, std::size_t key_set,
                                  const std::vector<MeasureInfo>& measures) {
  std::vector<std::string> notes;
  if (const auto names = methods_with_rates(report, key_set); !names.empty())
    notes.push_back(formatted("{} took the logged rates at the keys too.", joined(names, ", ")));
  for (const MeasureInfo& measure : measures)
    if (is_infinite_for_some(measure, report, key_set)) notes.push_back(note_on_infinite(measure));
  if (rests_at_some(report, key_set)) notes.emplace_back("The shape is undefined (–) where the body rests at a key.");
  if (report.leave_out == LeaveOut::yes)
    notes.emplace_back("Left out: an estimate of the error from the keys alone; it is not fit for choosing a method.");
  return notes;
}

report::Table table_of(const CompareReport& report, std::size_t key_set) {
  report::Table table{.title = title_of(report, report.data.key_sets[key_set]), .columns = {{"method"}, {"order"}}};
  std::vector<MeasureInfo> measures = measures_of(report);
  std::erase_if(measures, [](const MeasureInfo& measure) { return measure.heading.empty(); });
  for (const MeasureInfo& measure : measures)
    table.columns.push_back({.name = std::string(measure.heading),
                             .digits = measure.digits,
                             .rank = measure.word == report.sort ? 0 : measure.rank});
  table.columns.push_back({""});  // why a method failed
  for (const ComparedMethod& method : report.methods) {
    if (method.key_set != key_set) continue;
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{method.label, continuity_of(method)});
    for (const MeasureInfo& measure : measures) row.push_back(cell_of(method, measure, report.data));
    if (!method.measures) row.emplace_back(describe(method.measures.error()));
  }
  table.notes = notes_of(report, key_set, measures);
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

std::vector<MeasureInfo> measures_of(const CompareReport& report) {
  return report.data.measures(report.leave_out, report.inertia);
}

std::optional<double> value_of(const MeasureInfo& measure, const ComparedMethod& method, const ComparedData& data) {
  if (!method.measures) return std::nullopt;
  return measure.value(*method.measures, data.measure_times());
}

std::string title_of(const CompareReport& report, const ComparedKeys& keys) {
  const std::string reference = printable(file_name_of(report.data.reference));
  const std::string what = keys.decimation
                               ? formatted("{}: {} sample kept", reference, name_of(*keys.decimation))
                               : formatted("{} against {}", printable(file_name_of(keys.track.name)), reference);
  return formatted("{}, {}, {} compared", what, counted(keys.track.keys.size(), "key"),
                   counted(keys.compared, "sample"));
}

std::string text_of(const CompareReport& report, std::optional<std::size_t> width) {
  std::string text;
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  for (std::size_t i = 0; i < report.data.key_sets.size(); ++i)
    text.append(text.empty() ? "" : "\n")
        .append(width ? text_of(table_of(report, i), *width, not_shown) : text_of(table_of(report, i)));
  return text;
}

std::string line_of(const CompareReport& report) {
  const auto measures = measures_of(report);
  const auto sorted_by = std::ranges::find(measures, report.sort, &MeasureInfo::word);
  std::string line;
  for (std::size_t i = 0; i < report.data.key_sets.size(); ++i) {
    const auto best = std::ranges::find(report.methods, i, &ComparedMethod::key_set);
    const auto value = value_of(*sorted_by, *best, report.data);
    const auto& decimation = report.data.key_sets[i].decimation;
    line += formatted("{}{}{}", line.empty() ? "" : ", ", best->label, decimation ? " at " + name_of(*decimation) : "");
    if (value) line += formatted(" ({:.4g} {})", *value, sorted_by->unit);
  }
  return "best by " + report.sort + ": " + line;
}

std::string csv_of(const CompareReport& report) {
  const std::vector<MeasureInfo> measures = measures_of(report);
  std::string text = "method,keep_every,keys,samples";
  for (const MeasureInfo& measure : measures) text += formatted(",{}", measure.id);
  text += ",error\n";
  for (const ComparedMethod& method : report.methods) {
    const ComparedKeys& keys = report.data.key_sets[method.key_set];
    text += formatted("{},{},{},{}", csv_cell(method.label),
                      keys.decimation ? std::to_string(keys.decimation->keep_every) : "", keys.track.keys.size(),
                      keys.compared);
    for (const MeasureInfo& measure : measures) {
      const auto value = value_of(measure, method, report.data);
      text += value ? formatted(",{}", *value) : ",";
    }
    text += "," + (method.measures ? "" : csv_cell(describe(method.measures.error()))) + "\n";
  }
  return text;
}

}  // namespace orispline::cli
