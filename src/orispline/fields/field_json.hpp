// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>

#include <orispline/base/decimal.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/json.hpp>

// The fields of results as members of JSON documents.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Where the samples of a recording are in its file.
struct Places {
  std::span<const std::uint32_t> lines{};             ///< empty where the file has none
  std::function<Decimal(std::size_t sample)> time{};  ///< in the file's own time [s]

  [[nodiscard]] Json line_of(std::size_t sample) const { return lines.empty() ? Json(nullptr) : Json(lines[sample]); }
};

/// What the field of an option is where nothing is stated.
[[nodiscard]] Json default_json(const FieldInfo& field);

/// What becomes of members without a value.
enum class Absent { null, left_out };

void put_fields(Json& json, std::span<const FieldInfo> fields, const void* result, const Places& places = {},
                Absent absent = Absent::null);

/// All fields of a result.
template <class Result>
void put(Json& json, const Result& result, const Places& places = {}, Absent absent = Absent::null) {
  put_fields(json, fields_of<Result>(), &result, places, absent);
}

/// Those of that name, in this order.
template <class Result>
void put(Json& json, const Result& result, std::initializer_list<std::string_view> names, const Places& places = {}) {
  for (const std::string_view name : names)
    put_fields(json, {&field_named(fields_of<Result>(), name), 1}, &result, places);
}

}}  // namespace orispline
