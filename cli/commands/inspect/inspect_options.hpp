// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/inspect/inspect.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline inspect`, and what the help says about them.
void add_inspect_options(Command& app, InspectArguments& options);

}  // namespace orispline::cli
