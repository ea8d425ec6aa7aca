// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <nanobind/nanobind.h>

#include <orispline/base/warning.hpp>
#include <orispline/fields.hpp>
#include <orispline/fields/json.hpp>

#include "text.hpp"

// The fields of the library's options and results, as Python states and sees them.

namespace orispline::python {

/// Options by name: texts, as on the command line, or numbers in the units of the library. Raises ArgumentError.
void take_options(std::span<const FieldInfo> fields, void* options, const nanobind::dict& stated);

/// The options that are stated, all others at their defaults.
template <class Options>
Options options_in(const nanobind::dict& stated) {
  Options options{};
  take_options(fields_of<Options>(), &options, stated);
  return options;
}

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
