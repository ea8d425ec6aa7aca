// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "handles.hpp"

namespace orispline::c {

/// An error as C is told it.
struct ToldError {
  orispline_code code = ORISPLINE_OK;
  Error error{};
  std::string text{};  ///< the whole of it, in one line
};

template <>
struct HandleOf<orispline_error> {
  using Body = ToldError;
  static constexpr Kind kind = Kind::error;
};

/// Gives an error to who asked for it, and its code.
[[nodiscard]] orispline_code tell(Error error, orispline_error** to);
/// Tells that memory has run out, which takes none itself.
[[nodiscard]] orispline_code tell_no_memory(orispline_error** to) noexcept;
/// Tells of an exception that the library should not have thrown.
[[nodiscard]] orispline_code tell_fault(std::string_view what, orispline_error** to) noexcept;

/// Does what a function of C is to do, so that no exception leaves it. `work` gives an Expected<void>.
template <class Work>
[[nodiscard]] orispline_code guarded(orispline_error** error, Work work) noexcept {
  const auto done_or_told = [&] {
    Expected<void> done = work();
    return done ? ORISPLINE_OK : tell(std::move(done.error()), error);
  };
#ifdef __cpp_exceptions
  try {
    return done_or_told();
  } catch (const std::bad_alloc&) {
    return tell_no_memory(error);
  } catch (const std::length_error&) {
    return tell_no_memory(error);
  } catch (const std::exception& fault) {
    return tell_fault(fault.what(), error);
  } catch (...) {
    return tell_fault("", error);
  }
#else
  return done_or_told();
#endif
}

/// A copy of a text, or of bytes, which orispline_text_free() frees. Throws std::bad_alloc.
[[nodiscard]] char* text_of_c(std::string_view text);

/// Texts of the caller. Error (bad_argument): one of them is null.
[[nodiscard]] Expected<std::span<const char* const>> texts_in(const char* const* texts, std::size_t count,
                                                              std::string_view name);

}  // namespace orispline::c
