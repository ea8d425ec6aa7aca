// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/align/align.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline align`, and what the help says about them.
void add_align_options(Command& app, AlignArguments& options);

}  // namespace orispline::cli
