// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/studio/studio.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline studio`, and what the help says about them.
void add_studio_options(Command& app, StudioArguments& options);

}  // namespace orispline::cli
