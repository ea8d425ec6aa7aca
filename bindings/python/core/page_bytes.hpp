// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nanobind/nanobind.h>

namespace orispline::python {

/// The text that `make()` gives, which works without Python's lock; bytes, since names in it need not be UTF-8.
template <class Make>
[[nodiscard]] nanobind::bytes bytes_of(const Make& make) {
  const std::string text = [&] {
    const nanobind::gil_scoped_release release;
    return make();
  }();
  return nanobind::bytes(text.data(), text.size());
}

}  // namespace orispline::python
