// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/jobs/studio.hpp>

#include "commands/studio/studio.hpp"

namespace orispline::cli {

/// The command line, understood, and what its file holds: with the bytes of the file where no option changed how they
/// are read and they are a table of text, else with the keys as a CSV file, of which a warning tells.
[[nodiscard]] Expected<jobs::StudioRequest> studio_request(const StudioArguments& options);

}  // namespace orispline::cli
