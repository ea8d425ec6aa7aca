// SPDX-License-Identifier: Apache-2.0
#include "output/exit_code.hpp"

#include "options/option_text.hpp"
#include "options/reading_flags.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

ExitCode report(const Error& error) {
  tell("orispline: " + describe(with_flags(with_reading_flags(error))) + "\n");
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
