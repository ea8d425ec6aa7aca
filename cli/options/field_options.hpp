// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orispline/fields/field_info.hpp>

#include "options/command.hpp"

// The fields of the library's options as options of the command.

namespace orispline::cli {

/// Fields as typed, by their names.
using TypedFields = std::map<std::string_view, std::optional<std::string>, std::less<>>;

[[nodiscard]] bool is_given(const TypedFields& typed, std::string_view name);

/// An option named as the field: `gyro_noise` is --gyro-noise.
void add_field(Command& command, TypedFields& typed, const FieldInfo& field, std::string_view group);
/// One for each of them.
void add_fields(Command& command, TypedFields& typed, std::span<const FieldInfo> fields, std::string_view group);
/// A flag named as a word of the field, which it stands for, in the place of an option for all of its words.
void add_word_flag(Command& command, TypedFields& typed, const FieldInfo& field, std::string_view word,
                   std::string_view group);

/// Takes over what was typed. Error: bad_argument.
[[nodiscard]] Expected<void> take_fields(const TypedFields& typed, std::span<const FieldInfo> fields, void* options);

/// The options that were typed, all others at their defaults. Error: bad_argument.
template <class Options>
[[nodiscard]] Expected<Options> options_in(const TypedFields& typed, Options options = {}) {
  return take_fields(typed, fields_of<Options>(), &options).map([&] { return std::move(options); });
}

}  // namespace orispline::cli
