// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/math/eigen.hpp>

// The JSON of pages: numbers rounded to what a line on a screen can show, and texts that end no script.

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// In quotes; `<` stands as \u003c.
[[nodiscard]] std::string text_of(std::string_view text);
/// With 7 significant digits; `null` where it is not finite.
[[nodiscard]] std::string number_text(double value);

/// One flat array.
[[nodiscard]] std::string list_of(const std::vector<double>& values);
[[nodiscard]] std::string list_of(const std::vector<Eigen::Vector3d>& values);     ///< x, y, z of each
[[nodiscard]] std::string list_of(const std::vector<Eigen::Quaterniond>& values);  ///< w, x, y, z of each
[[nodiscard]] std::string list_of(const std::vector<long long>& values);

using Member = std::pair<std::string_view, std::string>;  // name, JSON
[[nodiscard]] std::string object_of(std::initializer_list<Member> members);

/// A line for each of the values.
template <class Value, class JsonOf>
[[nodiscard]] std::string array_of(const std::vector<Value>& values, JsonOf json_of_value) {
  std::string json = "[";
  for (const Value& value : values) json += (json.size() > 1 ? ",\n" : "") + json_of_value(value);
  return json + ']';
}

}}}  // namespace orispline::report
