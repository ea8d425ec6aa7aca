// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_json.hpp>

#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace orispline::inline ORISPLINE_ABI::report {
namespace {

/// What a line on a screen can show; keeps the file small.
constexpr int significant_digits = 7;

std::string text_of(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || c == '"' || c == '\\' || c == '<') fmt::format_to(std::back_inserter(json), "\\u{:04x}", code);
    else json += c;
  }
  return json + '"';
}

void append(std::string& json, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(json), "{:.{}g}", value, significant_digits);
  else json += "null";
}

std::string json_of(double value) {
  std::string json;
  append(json, value);
  return json;
}

/// One flat array of what `numbers_of` gives for each value.
template <class Value, class NumbersOf>
std::string list_of(std::span<const Value> values, NumbersOf numbers_of) {
  std::string json = "[";
  for (const Value& value : values)
    for (const double number : numbers_of(value)) {
      if (json.size() > 1) json += ',';
      append(json, number);
    }
  return json + ']';
}

std::string list_of(const std::vector<double>& values) {
  return list_of(std::span(values), [](double v) { return std::array{v}; });
}

std::string list_of(const std::vector<Eigen::Vector3d>& values) {
  return list_of(std::span(values), [](const Eigen::Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; });
}

std::string list_of(const std::vector<Eigen::Quaterniond>& values) {
  return list_of(std::span(values), [](const Eigen::Quaterniond& q) { return std::array{q.w(), q.x(), q.y(), q.z()}; });
}

using Member = std::pair<std::string_view, std::string>;  // name, JSON

std::string object_of(std::initializer_list<Member> members) {
  std::string json = "{";
  for (const auto& [name, value] : members)
    fmt::format_to(std::back_inserter(json), "{}\"{}\":{}", json.size() > 1 ? "," : "", name, value);
  return json + '}';
}

template <class Value, class JsonOf>
std::string array_of(const std::vector<Value>& values, JsonOf json_of_value) {
  std::string json = "[";
  for (const Value& value : values) json += (json.size() > 1 ? ",\n" : "") + json_of_value(value);
  return json + ']';
}

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

}  // namespace orispline::inline ORISPLINE_ABI::report
