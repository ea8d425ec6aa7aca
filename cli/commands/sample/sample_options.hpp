// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline sample`, and what the help says about them.
void add_sample_options(Command& app, SampleArguments& options);

}  // namespace orispline::cli
