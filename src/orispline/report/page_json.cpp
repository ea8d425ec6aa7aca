// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_json.hpp>

#include <array>
#include <string_view>

#include <orispline/report/json_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

std::string json_of(double value) { return number_text(value); }

std::string json_of(const PagePath& path) {
  return object_of({{"t", list_of(path.times)}, {"q", list_of(path.orientations)}});
}

std::string json_of(const PageKeys& keys) {
  return object_of(
      {{"t", list_of(keys.path.times)}, {"q", list_of(keys.path.orientations)}, {"p", list_of(keys.positions)}});
}

std::string json_of(const PageSamples& samples) {
  return object_of({{"t", list_of(samples.path.times)},
                    {"q", list_of(samples.path.orientations)},
                    {"w", list_of(samples.angular_velocities)},
                    {"a", list_of(samples.angular_accelerations)},
                    {"j", list_of(samples.angular_jerks)},
                    {"torque", list_of(samples.torques)},
                    {"p", list_of(samples.positions)},
                    {"error_t", list_of(samples.error_times)},
                    {"error_deg", list_of(samples.errors)}});
}

std::string_view name_of(Better better) {
  constexpr std::array<std::string_view, 3> names{"less", "more", "neither"};
  return names[static_cast<std::size_t>(better)];
}

std::string_view name_of(PageBody body) {
  constexpr std::array<std::string_view, 3> names{"aircraft", "box", "axes"};
  return names[static_cast<std::size_t>(body)];
}

std::string json_of(const PageUnit& unit) {
  return object_of({{"unit", text_of(unit.name)}, {"size", json_of(unit.size)}});
}

std::string json_of(const PageBand& band) {
  return object_of({{"label", text_of(band.label)},
                    {"t", list_of(band.times)},
                    {"low", list_of(band.low)},
                    {"high", list_of(band.high)}});
}

std::string json_of(const PageColumn& column) {
  return object_of({{"id", text_of(column.id)},
                    {"label", text_of(column.label)},
                    {"unit", text_of(column.unit)},
                    {"explanation", text_of(column.explanation)},
                    {"better", text_of(name_of(column.better))},
                    {"is_time", column.is_time ? "true" : "false"},
                    {"rounding", json_of(column.rounding)}});
}

std::string json_of(const PageMarks& marks) {
  return object_of({{"label", text_of(marks.label)},
                    {"t", list_of(marks.path.times)},
                    {"q", list_of(marks.path.orientations)},
                    {"error_deg", list_of(marks.errors)}});
}

template <class Value>
std::string json_or_null(const std::optional<Value>& value) {
  return value ? json_of(*value) : "null";
}

template <class Value>
std::string json_of(const std::map<std::string, Value, std::less<>>& values) {
  std::string json = "{";
  for (const auto& [id, value] : values) {
    if (json.size() > 1) json += ',';
    json.append(text_of(id)).append(":").append(json_of(value));
  }
  return json + '}';
}

std::string json_of(const PageMethod& method) {
  return object_of({{"name", text_of(method.name)},
                    {"continuity", text_of(method.continuity)},
                    {"failure", text_of(method.failure)},
                    {"measures", json_of(method.measures)},
                    {"samples", json_of(method.samples)},
                    {"keys", json_or_null(method.keys)},
                    {"bands", json_of(method.bands)}});
}

}  // namespace

std::string json_of(const Page& page) {
  return object_of({{"title", text_of(page.title)},
                    {"command", text_of(page.command)},
                    {"date", text_of(page.date)},
                    {"version", text_of(page.version)},
                    {"time_start", text_of(page.time_start)},
                    {"notes", array_of(page.notes, [](const std::string& note) { return text_of(note); })},
                    {"body", text_of(name_of(page.body))},
                    {"keys", json_of(page.keys)},
                    {"reference", json_or_null(page.reference)},
                    {"marks", json_or_null(page.marks)},
                    {"limits", json_of(page.limits)},
                    {"units", json_of(page.units)},
                    {"columns", array_of(page.columns, [](const PageColumn& c) { return json_of(c); })},
                    {"sorted_by", text_of(page.sorted_by)},
                    {"first", text_of(page.first)},
                    {"second", text_of(page.second)},
                    {"methods", array_of(page.methods, [](const PageMethod& m) { return json_of(m); })}});
}

}}}  // namespace orispline::report
