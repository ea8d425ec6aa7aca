// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/analysis/measure_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A method by the name that its user gives it, on one of several sets of keys.
struct ComparedMethod {
  std::string label;
  std::size_t key_set = 0;
  Candidate candidate;
  Expected<Measures> measures{};  ///< or why there are none
};

/// Puts the best method first in each set of keys, what failed last; those of which nothing can be said before them.
ORISPLINE_EXPORT void sort_by(const MeasureInfo& measure, std::vector<ComparedMethod>& methods,
                              const MeasureTimes& times);

}}  // namespace orispline
