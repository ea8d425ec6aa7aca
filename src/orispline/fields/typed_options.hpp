// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What is stated for the option of a name, a text as it is typed or a value in the unit of the library; null where
/// nothing is.
using StatedValue = std::function<const FieldValue*(std::string_view name)>;

/// Takes over what is stated of the fields of options, but for recordings, which are no text. Errors: those of
/// typed_value(); bad_argument for a value that is not of the field's type.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> take_stated(std::span<const FieldInfo> fields, const StatedValue& stated,
                                                          void* options);

/// The options that are stated, all others at their defaults. Errors: those of take_stated().
template <class Options>
[[nodiscard]] Expected<Options> stated_options(const StatedValue& stated, Options options = {}) {
  return take_stated(fields_of<Options>(), stated, &options).map([&] { return std::move(options); });
}

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
