// SPDX-License-Identifier: Apache-2.0
#include "output/exit_code.hpp"

#include <orispline/base/formatted.hpp>

#include "options/option_text.hpp"
#include "options/reading_flags.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

std::string exit_codes() {
  std::string text = "Exit codes:";
  for (const auto& [code, meaning] : exit_meanings) text += formatted(" {} {},", static_cast<int>(code), meaning);
  text.back() = '.';
  return text;
}

std::string message_of(const Error& error) { return describe(with_flags(with_reading_flags(error))); }

ExitCode report(const Error& error) {
  tell("orispline: " + message_of(error) + "\n");
  switch (error.code) {
    case ErrorCode::bad_argument:
      return ExitCode::bad_usage;
    case ErrorCode::bad_access:
      return ExitCode::bad_access;
    case ErrorCode::bad_data:
    case ErrorCode::not_converged:
    case ErrorCode::cancelled:
      break;
  }
  return ExitCode::bad_data;
}

}  // namespace orispline::cli
