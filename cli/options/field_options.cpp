// SPDX-License-Identifier: Apache-2.0
#include "options/field_options.hpp"

#include <algorithm>
#include <cctype>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/typed_options.hpp>

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

}  // namespace

bool is_given(const TypedFields& typed, std::string_view name) {
  const auto found = typed.find(name);
  return found != typed.end() && found->second;
}

void add_field(Command& command, TypedFields& typed, const FieldInfo& field, std::string_view group) {
  const bool is_negated = !field.without.empty();
  command.add({.names = is_negated ? flag_of(formatted("no_{}", field.name)) : flag_of(field.name),
               .sentence = is_negated ? std::string(field.without) : help_of(field),
               .typed = &typed[field.name],
               .stands_for = field.type != FieldType::flag ? ""
                             : is_negated                  ? "false"
                                                           : "true",
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
  const auto stated = [&](std::string_view name) {
    return is_given(typed, name) ? &*typed.find(name)->second : nullptr;
  };
  return take_typed(fields, stated, options);
}

}  // namespace orispline::cli
