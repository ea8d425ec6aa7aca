// SPDX-License-Identifier: Apache-2.0
#include "options/field_options.hpp"

#include <algorithm>
#include <cctype>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {
namespace {

std::string upper(std::string_view text) {
  std::string word(text);
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

std::string argument_of(const Quantity* quantity) {
  if (!quantity) return "X";
  const bool has_unit = !quantity->typed_units.empty() && !quantity->typed_units.back().name.empty();
  return upper(has_unit ? quantity->name : quantity->unit);
}

/// What is typed behind the option.
std::string argument_of(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::count:
      return "N";
    case FieldType::number:
    case FieldType::limit:
      return argument_of(field.quantity);
    case FieldType::word:
      return one_of(field.words);
    case FieldType::names:
      return "NAME,...";
    case FieldType::interval:
      return "LOWEST,HIGHEST";
    case FieldType::vector:
      return "X,Y,Z";
    case FieldType::symmetric_matrix:
      return "JX,JY,JZ";
    case FieldType::recording:
      return file_type;
    default:
      return "";
  }
}

/// How it is typed, and what holds where it is not.
std::string help_of(const FieldInfo& field) {
  std::string text(field.sentence);
  const std::string_view usual = field.quantity ? field.quantity->example : "";
  if (const auto example = field.example.empty() ? usual : field.example; !example.empty())
    text += formatted(", such as {}", example);
  if (field.type == FieldType::symmetric_matrix)
    text += formatted(": principal moments, or JXX,JYY,JZZ,JXY,JXZ,JYZ, in {}", field.quantity->unit);
  const FieldValue initial = field.initial();
  const bool shows = field.type == FieldType::word || field.type == FieldType::count;
  const std::string standing = !field.absent.empty() ? std::string(field.absent) : shows ? text_of(initial) : "";
  return standing.empty() ? text : formatted("{} [{}]", text, standing);
}

Expected<FieldValue> number_value(const FieldInfo& field, OptionText option) {
  if (field.quantity && !field.quantity->typed_units.empty()) return quantity_in(option, field.quantity->typed_units);
  const OptionText bare = without_unit(option, field.quantity ? field.quantity->unit : "");
  if (!field.quantity && option.text.find('/') != std::string_view::npos) return wanted(option, "a number");
  const auto read = [&field](OptionText text) {
    return field.range.lowest > 0.0 ? positive_in(text) : quotient_in(text);
  };
  const auto number = read(bare);
  return number ? number : read(option);
}

Expected<FieldValue> word_value(const FieldInfo& field, OptionText option) {
  const auto found = std::ranges::find(field.words, option.text, &Word::word);
  if (found == field.words.end()) return wanted(option, one_of(field.words));
  return std::string(option.text);
}

Expected<FieldValue> names_value(OptionText option) {
  const auto pieces = pieces_of(option.text, ',');
  return std::vector<std::string>(pieces.begin(), pieces.end());
}

Expected<FieldValue> interval_value(OptionText option) {
  auto numbers = numbers_in(option);
  if (!numbers || numbers->size() != 2 || !((*numbers)[0] < (*numbers)[1]))
    return wanted(option, "LOWEST,HIGHEST, the lower one first");
  return std::move(*numbers);
}

Expected<FieldValue> matrix_value(OptionText option) {
  auto numbers = numbers_in(option);
  if (!numbers || (numbers->size() != 3 && numbers->size() != 6))
    return wanted(option, "three principal moments, or JXX,JYY,JZZ,JXY,JXZ,JYZ");
  return std::move(*numbers);
}

Expected<FieldValue> value_in(const FieldInfo& field, OptionText option) {
  switch (field.type) {
    case FieldType::flag:
      return FieldValue(true);
    case FieldType::count:
      return count_in(option, static_cast<std::size_t>(std::max(field.range.lowest, 0.0)));
    case FieldType::number:
      return number_value(field, option);
    case FieldType::word:
      return word_value(field, option);
    case FieldType::names:
      return names_value(option);
    case FieldType::interval:
      return interval_value(option);
    case FieldType::limit:
      return measured_in(option, field.quantity->typed_units, 3);
    case FieldType::vector:
      return vector_in(option).map([](const Eigen::Vector3d& v) { return std::vector{v.x(), v.y(), v.z()}; });
    default:
      return matrix_value(option);
  }
}

}  // namespace

bool is_given(const TypedFields& typed, std::string_view name) {
  const auto found = typed.find(name);
  return found != typed.end() && found->second;
}

void add_field(Command& command, TypedFields& typed, const FieldInfo& field, std::string_view group) {
  command.add({.names = flag_of(field.name),
               .sentence = help_of(field),
               .typed = &typed[field.name],
               .stands_for = field.type == FieldType::flag ? "true" : "",
               .argument = argument_of(field),
               .section = std::string(group),
               .is_required = field.is_required});
}

void add_fields(Command& command, TypedFields& typed, std::span<const FieldInfo> fields, std::string_view group) {
  for (const FieldInfo& field : fields) add_field(command, typed, field, group);
}

void add_word_flag(Command& command, TypedFields& typed, const FieldInfo& field, std::string_view word,
                   std::string_view group) {
  const auto found = std::ranges::find(field.words, word, &Word::word);
  ORISPLINE_EXPECT(found != field.words.end());
  command.add({.names = flag_of(word),
               .sentence = std::string(found->sentence),
               .typed = &typed[field.name],
               .stands_for = std::string(word),
               .section = std::string(group)});
}

Expected<void> take_fields(const TypedFields& typed, std::span<const FieldInfo> fields, void* options) {
  for (const FieldInfo& field : fields) {
    if (!is_given(typed, field.name) || field.type == FieldType::recording) continue;
    const std::string flag = flag_of(field.name);
    const auto value = value_in(field, {flag, *typed.find(field.name)->second});
    if (!value) return tl::unexpected(value.error());
    field.set(options, *value);
  }
  return {};
}

}  // namespace orispline::cli
