// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/field_json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Json place_json(std::size_t sample, const Places& places) {
  return {{"key", sample}, {"line", places.line_of(sample)}, {"time_s", places.time(sample).to_string()}};
}

/// A value of any type but the index of a sample.
struct ValueJson {
  const FieldInfo& field;
  const Places& places;

  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(double number) const { return field.quantity ? number * field.quantity->shown : number; }
  Json operator()(const std::vector<std::size_t>& samples) const {
    Json list = Json::array();
    for (const std::size_t sample : samples) list.push_back(place_json(sample, places));
    return list;
  }
  Json operator()(const std::vector<SampleRun>& runs) const {
    Json list = Json::array();
    for (const auto& [first, count] : runs)
      list.push_back({{"key", first}, {"line", places.line_of(first)}, {"samples", count}});
    return list;
  }
  Json operator()(const Measured& measured) const {
    return measured.numbers.size() == 1 ? Json(measured.numbers[0]) : Json(measured.numbers);
  }
  Json operator()(const auto& value) const { return value; }
};

}  // namespace

Json default_json(const FieldInfo& field) {
  const FieldValue value = field.initial();
  if (is_absent(value) || field.is_required) return nullptr;
  return std::visit(ValueJson{field, {}}, value);
}

void put_fields(Json& json, std::span<const FieldInfo> fields, const void* result, const Places& places,
                Absent absent) {
  for (const FieldInfo& field : fields) {
    const FieldValue value = field.get(result);
    const std::uint64_t* sample = field.type == FieldType::sample ? std::get_if<std::uint64_t>(&value) : nullptr;
    if (absent == Absent::left_out && is_absent(value)) continue;
    json[name_with_unit(field)] = sample ? Json(places.time(static_cast<std::size_t>(*sample)).to_string())
                                         : std::visit(ValueJson{field, places}, value);
  }
}

}}  // namespace orispline
