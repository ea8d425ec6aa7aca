// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_json.hpp>

#include <orispline/io/file_format.hpp>
#include <orispline/io/file_option.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Json json_of(const FormatInfo& format) {
  return {{"format", format.id},         {"title", format.title},
          {"summary", format.summary},   {"extensions", format.extensions},
          {"is_read", format.is_read()}, {"is_written", format.is_written()}};
}

template <class Target>
Json options_json(std::span<const FileOption<Target>> options) {
  Json list = Json::array();
  for (const FileOption<Target>& option : options)
    list.push_back({{"name", option.name},
                    {"sentence", option.sentence},
                    {"argument", option.argument ? Json(option.argument()) : Json(nullptr)},
                    {"several", option.is_repeated}});
  return list;
}

}  // namespace

void add_repairs(Json& json, const RepairReport& repairs) {
  json["duplicates_dropped"] = repairs.duplicates_dropped;
  json["invalid_dropped"] = repairs.invalid_dropped;
  json["rows_moved"] = repairs.rows_moved;
  json["normalised"] = repairs.normalised;
  json["rates_left_free"] = repairs.rates_left_free;
  json["rows_between"] = repairs.rows_between;
  json["largest_matrix_distance"] = repairs.largest_matrix_distance;
  json["largest_duplicate_deg"] = repairs.largest_duplicate_turn * degrees;
  json["largest_duplicate_m"] = repairs.largest_duplicate_distance;
}

Json files_json() {
  Json list = Json::array();
  for (const FormatInfo* const format : formats()) list.push_back(json_of(*format));
  return {{"formats", std::move(list)},
          {"reading", options_json(reading_options())},
          {"writing", options_json(writing_options())}};
}

}}}  // namespace orispline::io
