// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <utility>

#include <orispline/base/expected.hpp>

namespace orispline::python {

/// Raises the Python exception of an error, with its place as attributes: those of `orispline._errors`.
[[noreturn]] void raise(const Error& error);

/// The value, or the exception of the error.
template <class T>
T value_of(Expected<T> result) {
  if (!result) raise(result.error());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

}  // namespace orispline::python
