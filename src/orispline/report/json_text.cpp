// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/json_text.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <fmt/format.h>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

/// What a line on a screen can show; keeps the file small.
constexpr int significant_digits = 7;

void append(std::string& json, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(json), "{:.{}g}", value, significant_digits);
  else json += "null";
}

void append(std::string& json, long long value) { fmt::format_to(std::back_inserter(json), "{}", value); }

/// One flat array of what `numbers_of` gives for each value.
template <class Value, class NumbersOf>
std::string flat_list(std::span<const Value> values, NumbersOf numbers_of) {
  std::string json = "[";
  for (const Value& value : values)
    for (const auto number : numbers_of(value)) {
      if (json.size() > 1) json += ',';
      append(json, number);
    }
  return json + ']';
}

}  // namespace

std::string text_of(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || c == '"' || c == '\\' || c == '<') fmt::format_to(std::back_inserter(json), "\\u{:04x}", code);
    else json += c;
  }
  return json + '"';
}

std::string number_text(double value) {
  std::string json;
  append(json, value);
  return json;
}

std::string list_of(const std::vector<double>& values) {
  return flat_list(std::span(values), [](double v) { return std::array{v}; });
}

std::string list_of(const std::vector<long long>& values) {
  return flat_list(std::span(values), [](long long v) { return std::array{v}; });
}

std::string list_of(const std::vector<Eigen::Vector3d>& values) {
  return flat_list(std::span(values), [](const Eigen::Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; });
}

std::string list_of(const std::vector<Eigen::Quaterniond>& values) {
  return flat_list(std::span(values), [](const Eigen::Quaterniond& q) {
    return std::array{q.w(), q.x(), q.y(), q.z()};
  });
}

std::string object_of(std::initializer_list<Member> members) {
  std::string json = "{";
  for (const auto& [name, value] : members)
    fmt::format_to(std::back_inserter(json), "{}\"{}\":{}", json.size() > 1 ? "," : "", name, value);
  return json + '}';
}

}}}  // namespace orispline::report
