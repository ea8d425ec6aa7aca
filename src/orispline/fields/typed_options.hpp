// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The text that is stated for the option of a name; null where there is none.
using StatedText = std::function<const std::string*(std::string_view name)>;

/// Takes over what is stated of the fields of options, but for recordings, which are no text. Errors: those of
/// typed_value().
[[nodiscard]] ORISPLINE_EXPORT Expected<void> take_typed(std::span<const FieldInfo> fields, const StatedText& stated,
                                                         void* options);

/// The options that are stated, all others at their defaults. Errors: those of typed_value().
template <class Options>
[[nodiscard]] Expected<Options> typed_options(const StatedText& stated, Options options = {}) {
  return take_typed(fields_of<Options>(), stated, &options).map([&] { return std::move(options); });
}

}}  // namespace orispline
