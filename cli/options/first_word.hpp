// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "options/command.hpp"

namespace orispline::cli {

/// The words of the command line as the parser takes them: `help sample` is `sample --help`, `help` is `--help`.
///
/// Errors (bad_argument): a command that there is none of; `--option=` without a value.
[[nodiscard]] Expected<std::vector<std::string>> understood_words(const std::deque<Command>& commands,
                                                                  std::vector<std::string> words);

}  // namespace orispline::cli
