// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/base/expected.hpp>

#include "papers/reproduce_report.hpp"

namespace orispline::cli {

/// Writes the pictures of all experiments into a folder, which is made where it is missing, and notes their paths in
/// the reports. Errors: bad_access.
[[nodiscard]] Expected<void> write_pictures(std::vector<ExperimentReport>& reports, const std::string& folder);

/// Writes all that there is of each experiment: its pictures, its tables as text, and both as numbers in JSON. Errors:
/// bad_access.
[[nodiscard]] Expected<void> write_all(std::vector<ExperimentReport>& reports, const std::string& folder);

}  // namespace orispline::cli
