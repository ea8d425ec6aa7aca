// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/report/table.hpp>

#include "papers/experiment.hpp"

namespace orispline::cli {

/// What the paper on the 6th degree says of its curves in words only, measured: how even their speed is on uneven
/// knots, where their peaks are beside a true motion, and how far one β reaches.
[[nodiscard]] Expected<std::vector<report::Table>> sextic_qualities(const Flight& flight);

}  // namespace orispline::cli
