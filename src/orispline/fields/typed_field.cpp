// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/field_info.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/fields/typed_numbers.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::string_view matrix_words = "three principal moments, or JXX,JYY,JZZ,JXY,JXZ,JYZ";

std::uint64_t lowest_count(const FieldInfo& field) {
  return static_cast<std::uint64_t>(std::max(field.range.lowest, 0.0));
}

std::string_view unit_of(const FieldInfo& field) { return field.quantity ? field.quantity->unit : ""; }

Expected<FieldValue> flag_value(std::string_view text) {
  if (text != "true" && text != "false") return typed::wanted(text, "true or false");
  return FieldValue(text == "true");
}

Expected<FieldValue> number_value(const FieldInfo& field, std::string_view text) {
  if (field.quantity && !field.quantity->typed_units.empty())
    return typed::measured(text, field.quantity->typed_units, 1).map([](const Measured& m) {
      return FieldValue(m.numbers[0]);
    });
  if (!field.quantity && text.find('/') != std::string_view::npos) return typed::wanted(text, "a number");
  const auto read = [&field](std::string_view typed_text) {
    return field.range.lowest > 0.0 ? typed::positive(typed_text) : typed::quotient(typed_text);
  };
  const auto number = read(typed::without_unit(text, unit_of(field)));
  return number ? number : read(text);
}

Expected<FieldValue> word_value(const FieldInfo& field, std::string_view text) {
  if (std::ranges::find(field.words, text, &Word::word) == field.words.end())
    return typed::wanted(text, one_of(field.words));
  return FieldValue(std::string(text));
}

Expected<FieldValue> names_value(std::string_view text) {
  const auto pieces = pieces_of(text, ',');
  return FieldValue(std::vector<std::string>(pieces.begin(), pieces.end()));
}

Expected<FieldValue> interval_value(std::string_view text) {
  auto numbers = typed::numbers(text);
  if (!numbers || numbers->size() != 2 || !((*numbers)[0] < (*numbers)[1]))
    return typed::wanted(text, "LOWEST,HIGHEST, the lower one first");
  return FieldValue(std::move(*numbers));
}

Expected<FieldValue> matrix_value(std::string_view text) {
  auto numbers = typed::numbers(text);
  if (!numbers || (numbers->size() != 3 && numbers->size() != 6)) return typed::wanted(text, matrix_words);
  return FieldValue(std::move(*numbers));
}

Expected<FieldValue> value_in(const FieldInfo& field, std::string_view text) {
  switch (field.type) {
    case FieldType::flag:
      return flag_value(text);
    case FieldType::count:
      return typed::count(text, lowest_count(field));
    case FieldType::number:
      return number_value(field, text);
    case FieldType::word:
      return word_value(field, text);
    case FieldType::names:
      return names_value(text);
    case FieldType::interval:
      return interval_value(text);
    case FieldType::limit:
      return typed::measured(text, field.quantity->typed_units, 3);
    case FieldType::vector:
      return typed::vector(text);
    case FieldType::symmetric_matrix:
      return matrix_value(text);
    default:
      return typed::wanted(text, wanted_of(field));
  }
}

/// ` [rad]`, nothing without a unit.
std::string unit_in_brackets(const FieldInfo& field) {
  return field.quantity ? formatted(" [{}]", field.quantity->unit) : "";
}

/// `a, b or c`.
std::string words_in(const FieldInfo& field) {
  std::string text;
  for (std::size_t i = 0; i < field.words.size(); ++i)
    text += formatted("{}{}", i == 0 ? "" : i + 1 == field.words.size() ? " or " : ", ", field.words[i].word);
  return text;
}

}  // namespace

Expected<const FieldInfo*> find_field(std::span<const FieldInfo> fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, &FieldInfo::name);
  if (found != fields.end()) return &*found;
  std::vector<std::string_view> names;
  for (const FieldInfo& field : fields) names.push_back(field.name);
  return failure(ErrorCode::bad_argument, unknown_word("option", name, names));
}

Expected<FieldValue> typed_value(const FieldInfo& field, std::string_view text) {
  if (text == "auto" && field.absent.starts_with("auto:")) return FieldValue();
  return value_in(field, text).map_error([&field](Error error) {
    error.option = field.name;
    return error;
  });
}

std::string wanted_of(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::flag:
      return "true or false";
    case FieldType::count:
      return formatted("a whole number from {} on", lowest_count(field));
    case FieldType::number:
      return "a number" + unit_in_brackets(field);
    case FieldType::word:
      return words_in(field);
    case FieldType::names:
      return "names";
    case FieldType::interval:
      return "two numbers, the lower one first";
    case FieldType::limit:
      return "a number or three" + unit_in_brackets(field);
    case FieldType::vector:
      return "three numbers" + unit_in_brackets(field);
    case FieldType::symmetric_matrix:
      return formatted("{}{}", matrix_words, unit_in_brackets(field));
    default:
      return "orientations at times";
  }
}

}}  // namespace orispline
