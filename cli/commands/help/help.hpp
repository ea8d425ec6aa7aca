// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "options/command.hpp"

namespace orispline::cli {

/// `help COMMAND` is read as `COMMAND --help`, before it comes here.
struct HelpArguments {
  std::optional<std::string> command, manual_pages;
};

/// Writes the manual pages of the program and of all commands into the folder that the user named.
///
/// Errors: bad_argument for a command beside the folder; bad_access.
[[nodiscard]] Expected<void> help(const HelpArguments& arguments, const Program& program,
                                  const std::deque<Command>& commands);

}  // namespace orispline::cli
