// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What kind of thing went wrong; each binding maps it to its own habit (exit code, exception type).
enum class ErrorCode {
  bad_data,       ///< the keyframes or the content of a file
  bad_argument,   ///< a method name, parameter, end rule or option
  not_converged,  ///< the equations of a method, which it could not solve for the given keys
  bad_access,     ///< a file that cannot be opened, read, written or renamed
  cancelled,      ///< a task that was asked to stop
};

/// Where it went wrong. Every member may be absent.
struct Where {
  std::string file{};                       ///< path, or `-` for standard input
  std::optional<std::size_t> line{};        ///< 1-based, the header counted
  std::optional<std::size_t> column{};      ///< 1-based column of the table
  std::optional<std::size_t> key{};         ///< 0-based keyframe index
  std::optional<std::size_t> time_index{};  ///< 0-based index among the times that are asked for
  std::optional<std::size_t> curve{};       ///< 0-based index among many curves
};

/// One failure: the kind, one sentence that says what was found and what was wanted, and the place.
struct ORISPLINE_EXPORT Error {
  ErrorCode code = ErrorCode::bad_data;
  std::string message{};
  Where where{};
  /// The option that is at fault, by the name that the library gives it, such as `time_scale`; empty where there is
  /// none. Each binding tells in its terms how it is set, as well as those in backquotes in the message.
  std::string option{};
  /// The option that would mend it, such as `drop_duplicates`; empty where there is none.
  std::string remedy{};
};

/// A value or the reason why there is none.
template <class T>
using Expected = tl::expected<T, Error>;

/// Shorthand for returning a failure.
[[nodiscard]] inline tl::unexpected<Error> failure(ErrorCode code, std::string message, Where where = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

/// That of an option, by the name that the library gives it.
[[nodiscard]] inline tl::unexpected<Error> bad_option(std::string_view option, std::string message) {
  return tl::unexpected<Error>(Error{ErrorCode::bad_argument, std::move(message), {}, std::string(option), {}});
}

/// That of data which an option would mend, by the name that the library gives it.
[[nodiscard]] inline tl::unexpected<Error> mended_by(std::string_view remedy, std::string message, Where where = {}) {
  return tl::unexpected<Error>(
      Error{ErrorCode::bad_data, std::move(message), std::move(where), {}, std::string(remedy)});
}

/// `keys.csv:7:3: key 2: option: message (option remedy)`, with the absent parts left out: one printable
/// line for people.
[[nodiscard]] ORISPLINE_EXPORT std::string describe(const Error& error);

}}  // namespace orispline
