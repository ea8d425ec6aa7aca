// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/bake/bake.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline bake`, and what the help says about them.
void add_bake_options(Command& app, BakeArguments& options);

}  // namespace orispline::cli
