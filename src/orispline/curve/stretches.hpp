// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Successive keys without a gap.
struct Stretch {
  std::size_t first, count;
};

/// Rising times cut where an interval is longer than the gap [s]. Error (bad_argument): a gap that is not longer than
/// the median interval.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Stretch>> stretches_between_gaps(std::span<const double> times,
                                                                                     double gap);

}}  // namespace orispline
