// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/smooth/smooth.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline smooth`, and what the help says about them.
void add_smooth_options(Command& app, SmoothArguments& options);

}  // namespace orispline::cli
