// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/plot/plot.hpp"
#include "options/command_options.hpp"

namespace orispline::cli {

/// The options of `orispline plot`, and what the help says about them.
void add_plot_options(Command& app, PlotArguments& options);

}  // namespace orispline::cli
