// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/command.hpp"
#include "options/field_options.hpp"

namespace orispline::cli {

/// All options of smoothing.
void add_smoothing_options(Command& app, TypedFields& fields);
/// How smooth a recording is made: one of them, or none where that is chosen.
void add_smoothness_options(Command& app, TypedFields& fields);

}  // namespace orispline::cli
