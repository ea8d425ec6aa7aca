// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/reduce/reduce.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline reduce`, and what the help says about them.
void add_reduce_options(Command& app, ReduceArguments& options);

}  // namespace orispline::cli
