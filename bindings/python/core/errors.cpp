// SPDX-License-Identifier: Apache-2.0
#include "errors.hpp"

#include <optional>
#include <string>
#include <string_view>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include "text.hpp"

namespace nb = nanobind;

namespace orispline::python {

namespace {

std::string_view name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_argument:
      return "ArgumentError";
    case ErrorCode::not_converged:
      return "ConvergenceError";
    case ErrorCode::bad_access:
      return "AccessError";
    case ErrorCode::bad_data:
    case ErrorCode::cancelled:
      break;
  }
  return "DataError";
}

}  // namespace

void raise(const Error& error) {
  const nb::object type = nb::module_::import_("orispline._errors").attr(text(name_of(error.code)));
  const nb::object exception = type(shown(describe(error)));
  const auto set = [&](const char* name, const auto& value) { exception.attr(name) = nb::cast(value); };
  set("key", error.where.key);
  set("time_index", error.where.time_index);
  set("line", error.where.line);
  set("column", error.where.column);
  if (!error.where.file.empty()) set("file", error.where.file);
  if (!error.option.empty()) set("argument", error.option);
  PyErr_SetObject(type.ptr(), exception.ptr());
  throw nb::python_error();
}

}  // namespace orispline::python
