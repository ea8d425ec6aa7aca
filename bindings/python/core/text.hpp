// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <nanobind/nanobind.h>

// Strings of the library are bytes, such as the names of files. Those that are no UTF-8 come to Python as it has such
// names: each byte that belongs to no character as a lone surrogate (PEP 383), which goes back as that byte. So every
// string of Python goes in, and every string of the library comes out.

namespace orispline::python {

/// As data: what goes back is the same bytes.
[[nodiscard]] inline nanobind::str text(std::string_view bytes) {
  return nanobind::steal<nanobind::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape"));
}

/// As words to read, which any terminal takes: `temp_\xb0C`.
[[nodiscard]] inline nanobind::str shown(std::string_view bytes) {
  return nanobind::steal<nanobind::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "backslashreplace"));
}

}  // namespace orispline::python

namespace nanobind::detail {

/// In the place of nanobind's own (nanobind/stl/string.h), for which there are strings that cannot pass.
template <>
struct type_caster<std::string> {
  NB_TYPE_CASTER(std::string, const_name("str"))

  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    if (!PyUnicode_Check(source.ptr())) return false;
    Py_ssize_t size = 0;
    if (const char* const characters = PyUnicode_AsUTF8AndSize(source.ptr(), &size)) {
      value.assign(characters, static_cast<std::size_t>(size));
      return true;
    }
    PyErr_Clear();
    return encoded(source, "surrogateescape") || encoded(source, "surrogatepass");
  }

  static handle from_cpp(const std::string& value, rv_policy, cleanup_list*) noexcept {
    return orispline::python::text(value).release();
  }

 private:
  bool encoded(handle source, const char* errors) noexcept {
    const object bytes = steal(PyUnicode_AsEncodedString(source.ptr(), "utf-8", errors));
    char* characters = nullptr;
    Py_ssize_t size = 0;
    if (!bytes.is_valid() || PyBytes_AsStringAndSize(bytes.ptr(), &characters, &size) != 0) {
      PyErr_Clear();
      return false;
    }
    value.assign(characters, static_cast<std::size_t>(size));
    return true;
  }
};

}  // namespace nanobind::detail
