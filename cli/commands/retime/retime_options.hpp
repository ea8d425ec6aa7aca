// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/retime/retime.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline retime`, and what the help says about them.
void add_retime_options(Command& app, RetimeArguments& options);

}  // namespace orispline::cli
