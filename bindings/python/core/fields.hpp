// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>

#include <orispline/base/warning.hpp>
#include <orispline/fields.hpp>
#include <orispline/fields/json.hpp>

#include "text.hpp"

// The fields of the library's options and results, as Python states and sees them.

namespace orispline::python {

/// Options by name: texts, as on the command line, or numbers in the units of the library. None states nothing.
using StatedOptions = std::vector<std::pair<std::string, FieldValue>>;
[[nodiscard]] StatedOptions options_in(const nanobind::dict& stated);
/// Raises ArgumentError for a name that is none of the fields.
[[nodiscard]] StatedOptions options_in(const nanobind::dict& stated, std::span<const FieldInfo> fields);

/// Of a value that is not of the field's type, as Python shows it.
[[nodiscard]] Error of_another_type(const FieldInfo& field, const nanobind::handle& object);

/// The library's error about options, in which such a value is shown as Python shows it.
[[nodiscard]] Error as_shown(Error error, const nanobind::dict& stated, std::span<const FieldInfo> fields);

/// Values by name, in the units of the library; a sample is its index.
nanobind::dict attributes_of(std::span<const FieldInfo> fields, const void* result);
template <class Result>
nanobind::dict attributes_of(const Result& result) {
  return attributes_of(fields_of<Result>(), &result);
}

/// As Python has it: None, numbers, texts, lists and dicts.
nanobind::object object_of(const Json& json);

/// `(text, code, numbers)` of each.
nanobind::list warnings_of(std::span<const Warning> warnings);

}  // namespace orispline::python
