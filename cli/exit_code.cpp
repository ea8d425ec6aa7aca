// SPDX-License-Identifier: Apache-2.0
#include "exit_code.hpp"

#include "standard_output.hpp"

namespace orispline::cli {

ExitCode report(const Error& error) {
  tell("orispline: " + describe(error) + "\n");
  switch (error.code) {
    case ErrorCode::bad_argument:
      tell("Run 'orispline --help', or '--help' after a command, for what is accepted.\n");
      return ExitCode::bad_usage;
    case ErrorCode::bad_access:
      return ExitCode::bad_access;
    case ErrorCode::bad_data:
    case ErrorCode::not_converged:
      break;
  }
  return ExitCode::bad_data;
}

}  // namespace orispline::cli
