// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <orispline/fields/field_info.hpp>

// Fields as the users of a face state them: by name, and by text.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The field of that name. Error (bad_argument): there is none, with the one that is near.
[[nodiscard]] ORISPLINE_EXPORT Expected<const FieldInfo*> find_field(std::span<const FieldInfo> fields,
                                                                     std::string_view name);

/// What a text states for a field: `0.1deg`, `body`, `1,2,2.5`; the flags `true` and `false`. A number whose quantity
/// has units that people type wants one of them. Errors: bad_argument, with the field's name as the option; so for a
/// recording, which is no text.
[[nodiscard]] ORISPLINE_EXPORT Expected<FieldValue> typed_value(const FieldInfo& field, std::string_view text);

/// What a field takes, in words: `a number [rad]`, `body or world`, `a whole number from 1 on`.
[[nodiscard]] ORISPLINE_EXPORT std::string wanted_of(const FieldInfo& field);

}}  // namespace orispline
