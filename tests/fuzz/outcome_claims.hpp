// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <fuzz/claim.hpp>
#include <orispline/fields/json.hpp>

namespace orispline::fuzz {

/// JSON knows neither NaN nor infinity.
inline void claim_numbers(const Json& json, const std::string& name = "") {
  const auto& value = json.value();
  if (const auto* const number = std::get_if<double>(&value)) claim(std::isfinite(*number), "{} is {}", name, *number);
  if (const auto* const list = std::get_if<Json::Array>(&value))
    for (const Json& element : *list) claim_numbers(element, name + "[]");
  if (const auto* const object = std::get_if<Json::Object>(&value))
    for (const auto& [key, member] : *object) claim_numbers(member, name + "." + key);
}

/// What a binding tells of the outcome of a job.
template <class Outcome>
void claim_told(const Outcome& outcome) {
  claim_plain(outcome.warnings);
  claim_numbers(document_of(outcome));
  const std::string summary = summary_of(outcome);
  for (std::size_t at = 0; at < summary.size();) {
    const std::size_t end = std::min(summary.find('\n', at), summary.size());
    claim(end == at || is_one_printable_line(std::string_view(summary).substr(at, end - at)),
          "a summary with a line that is not printable: '{}'", summary);
    at = end + 1;
  }
  if constexpr (requires { line_of(outcome); })
    claim(is_one_printable_line(line_of(outcome)), "its line is not one printable line: '{}'", line_of(outcome));
}

}  // namespace orispline::fuzz
