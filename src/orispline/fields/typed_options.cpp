// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/typed_options.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
