// SPDX-License-Identifier: Apache-2.0
#include "fields.hpp"

#include <cmath>
#include <optional>

#include <nanobind/stl/vector.h>

#include "errors.hpp"
#include "keys.hpp"

namespace nb = nanobind;

namespace orispline::python {

namespace {

/// What Python states; nothing where it is of another type.
std::optional<FieldValue> value_of_object(const nb::handle& object) {
  if (nb::isinstance<nb::str>(object)) return nb::cast<std::string>(object);
  if (nb::isinstance<nb::bool_>(object)) return nb::cast<bool>(object);
  std::uint64_t count = 0;
  double number = 0.0;
  std::vector<double> numbers;
  std::vector<std::string> names;
  if (nb::isinstance<nb::int_>(object) && nb::try_cast(object, count)) return count;
  if (nb::try_cast(object, number)) return number;
  if (nb::try_cast(object, numbers)) return numbers;
  if (nb::try_cast(object, names)) return names;
  return std::nullopt;
}

std::string found_and_wanted(const FieldInfo& field, const std::string& found) {
  return "found " + found + ", wanted " + wanted_of(field);
}

struct Attribute {
  nb::object operator()(std::monostate) const { return nb::none(); }
  nb::object operator()(const Measured& measured) const { return nb::cast(measured.numbers); }
  nb::object operator()(const std::vector<SampleRun>& runs) const {
    nb::list list;
    for (const auto& [first, count] : runs) list.append(nb::make_tuple(first, count));
    return list;
  }
  nb::object operator()(const auto& value) const { return nb::cast(value); }
};

struct FromJson {
  nb::object operator()(std::nullptr_t) const { return nb::none(); }
  nb::object operator()(const Json::Array& values) const {
    nb::list list;
    for (const Json& value : values) list.append(object_of(value));
    return list;
  }
  nb::object operator()(const Json::Object& members) const {
    nb::dict object;
    for (const auto& [name, value] : members) object[text(name)] = object_of(value);
    return object;
  }
  nb::object operator()(const auto& value) const { return nb::cast(value); }
};

nb::object bound(double number) { return std::isfinite(number) ? nb::cast(number) : nb::object(nb::none()); }

nb::dict info_of(const FieldInfo& field) {
  nb::dict info;
  info["name"] = text(field.name);
  info["member"] = name_with_unit(field);
  info["type"] = text(name_of(field.type));
  info["unit"] = field.quantity && field.quantity->shown == 1.0 ? text(field.quantity->unit) : nb::object(nb::none());
  info["sentence"] = text(field.sentence);
  info["absent"] = text(field.absent);
  info["required"] = field.is_required;
  info["wanted"] = wanted_of(field);
  const bool has_default = field.initial && !field.is_required && !is_absent(field.initial());
  info["default"] = has_default ? std::visit(Attribute(), field.initial()) : nb::object(nb::none());
  info["lowest"] = bound(field.range.lowest);
  info["highest"] = bound(field.range.highest);
  nb::dict words;
  for (const Word& word : field.words) words[text(word.word)] = text(word.sentence);
  info["words"] = words;
  return info;
}

void put_infos(nb::dict& all, const char* name, std::span<const FieldInfo> fields) {
  nb::list list;
  for (const FieldInfo& field : fields) list.append(info_of(field));
  all[name] = list;
}

}  // namespace

StatedOptions options_in(const nb::dict& stated) {
  StatedOptions options;
  for (const auto& [key, object] : stated) {
    if (object.is_none()) continue;
    const auto name = nb::cast<std::string>(key);
    auto value = value_of_object(object);
    if (!value)
      raise({ErrorCode::bad_argument,
             "found " + nb::cast<std::string>(nb::repr(object)) + ", wanted a text or numbers",
             {},
             name});
    options.emplace_back(name, *std::move(value));
  }
  return options;
}

StatedOptions options_in(const nb::dict& stated, std::span<const FieldInfo> fields) {
  for (const auto& [name, object] : stated) value_of(find_field(fields, nb::cast<std::string>(name)));
  return options_in(stated);
}

Error of_another_type(const FieldInfo& field, const nb::handle& object) {
  return {ErrorCode::bad_argument,
          found_and_wanted(field, nb::cast<std::string>(nb::repr(object))),
          {},
          std::string(field.name)};
}

Error as_shown(Error error, const nb::dict& stated, std::span<const FieldInfo> fields) {
  const auto field = find_field(fields, error.option);
  if (!field || !stated.contains(error.option.c_str())) return error;
  const nb::object object = stated[error.option.c_str()];
  const auto value = value_of_object(object);
  if (value && error.message == found_and_wanted(**field, text_of(*value))) return of_another_type(**field, object);
  return error;
}

nb::dict attributes_of(std::span<const FieldInfo> fields, const void* result) {
  nb::dict attributes;
  for (const FieldInfo& field : fields) attributes[text(field.name)] = std::visit(Attribute(), field.get(result));
  return attributes;
}

nb::object object_of(const Json& json) { return std::visit(FromJson(), json.value()); }

nb::list warnings_of(std::span<const Warning> warnings) {
  nb::list list;
  for (const Warning& warning : warnings) {
    nb::dict numbers;
    for (const auto& [name, number] : warning.numbers) numbers[text(name)] = number;
    list.append(nb::make_tuple(shown(describe(warning)), text(warning.code), numbers));
  }
  return list;
}

void add_fields(nb::module_& module) {
  module.def("fields", [] {
    nb::dict all;
    put_infos(all, "SmoothOptions", fields_of<SmoothOptions>());
    put_infos(all, "Smoothing", fields_of<Smoothing>());
    put_infos(all, "ReduceOptions", fields_of<ReduceOptions>());
    put_infos(all, "Reduction", fields_of<Reduction>());
    put_infos(all, "ClipReduceOptions", fields_of<ClipReduceOptions>());
    put_infos(all, "ClipEdits", fields_of<ClipEdits>());
    put_infos(all, "RetimeOptions", fields_of<RetimeOptions>());
    put_infos(all, "Retiming", fields_of<Retiming>());
    put_infos(all, "TuneOptions", fields_of<TuneOptions>());
    put_infos(all, "Tuning", fields_of<Tuning>());
    put_infos(all, "MeanOptions", fields_of<MeanOptions>());
    put_infos(all, "Mean", fields_of<Mean>());
    put_infos(all, "AlignOptions", fields_of<AlignOptions>());
    put_infos(all, "Alignment", fields_of<Alignment>());
    put_infos(all, "RateAlignment", fields_of<RateAlignment>());
    put_infos(all, "Decimation", fields_of<Decimation>());
    put_infos(all, "MeasureOptions", fields_of<MeasureOptions>());
    return all;
  });
}

}  // namespace orispline::python
