// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/difference/difference.hpp"
#include "options/command.hpp"

namespace orispline::cli {

void add_difference_options(Command& app, DifferenceArguments& options);

}  // namespace orispline::cli
