// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/tune/tune.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline tune`, and what the help says about them.
void add_tune_options(Command& app, TuneArguments& options);

}  // namespace orispline::cli
