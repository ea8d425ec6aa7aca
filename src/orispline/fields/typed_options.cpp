// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/typed_options.hpp>

#include <variant>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whole numbers are numbers too.
bool set(const FieldInfo& field, void* options, const FieldValue& value) {
  if (field.set(options, value)) return true;
  const auto* const count = std::get_if<std::uint64_t>(&value);
  return count && field.set(options, static_cast<double>(*count));
}

}  // namespace

Expected<void> take_stated(std::span<const FieldInfo> fields, const StatedValue& stated, void* options) {
  for (const FieldInfo& field : fields) {
    const FieldValue* const value = stated(field.name);
    if (!value || field.type == FieldType::recording) continue;
    if (const auto* const text = std::get_if<std::string>(value)) {
      const auto typed = typed_value(field, *text);
      if (!typed) return tl::unexpected(typed.error());
      field.set(options, *typed);
    } else if (!std::holds_alternative<std::monostate>(*value) && !set(field, options, *value)) {
      return bad_option(field.name, formatted("found {}, wanted {}", text_of(*value), wanted_of(field)));
    }
  }
  return {};
}

Expected<void> take_typed(std::span<const FieldInfo> fields, const StatedText& stated, void* options) {
  for (const FieldInfo& field : fields) {
    const std::string* const text = stated(field.name);
    if (!text || field.type == FieldType::recording) continue;
    const auto value = typed_value(field, *text);
    if (!value) return tl::unexpected(value.error());
    field.set(options, *value);
  }
  return {};
}

}}  // namespace orispline
