// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/compare/compare.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline compare`, and what the help says about them.
void add_compare_options(Command& app, CompareArguments& options);

}  // namespace orispline::cli
