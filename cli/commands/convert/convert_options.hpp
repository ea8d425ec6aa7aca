// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/convert/convert.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline convert`, and what the help says about them.
void add_convert_options(Command& app, ConvertArguments& options);

}  // namespace orispline::cli
