// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/mean/mean.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline mean`, and what the help says about them.
void add_mean_options(Command& app, MeanArguments& options);

}  // namespace orispline::cli
