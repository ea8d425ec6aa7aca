// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

enum class ExitCode : int {
  success = 0,
  bad_data = 1,    ///< the content of a file
  bad_usage = 2,   ///< the command line
  bad_access = 3,  ///< input that is missing or unreadable, output that cannot be written
};

struct ExitMeaning {
  ExitCode code;
  std::string_view meaning;
};

/// What users are told about each.
inline constexpr std::array exit_meanings{
    ExitMeaning{ExitCode::success, "success"}, ExitMeaning{ExitCode::bad_data, "bad data"},
    ExitMeaning{ExitCode::bad_usage, "bad usage"},
    ExitMeaning{ExitCode::bad_access, "file missing, unreadable or not writable"}};

/// All of them in a sentence.
[[nodiscard]] std::string exit_codes();

/// What report() says, without the name of the program.
[[nodiscard]] std::string message_of(const Error& error);

/// Says on standard error what is wrong, in one line and for a bad command line where to read on. THE place where
/// errors become exit codes.
[[nodiscard]] ExitCode report(const Error& error);

}  // namespace orispline::cli
