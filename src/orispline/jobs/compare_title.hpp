// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/jobs/compare.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// `flight.csv: every 8th sample kept, 11 keys, 81 samples compared`, `keys.csv against truth.csv, …`, with the names
/// of the files and not their folders.
[[nodiscard]] std::string title_of(const CompareOutcome& outcome, std::size_t key_set);

}}}  // namespace orispline::jobs
