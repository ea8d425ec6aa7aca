// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/spans_to_end.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

SpansToEnd::SpansToEnd(std::vector<std::size_t> farthest) : spans_(farthest.size(), 0) {
  for (std::size_t i = 1; i < farthest.size(); ++i) farthest[i] = std::max(farthest[i], farthest[i - 1]);
  for (std::size_t i = farthest.size() - 1; i-- > 0;) spans_[i] = 1 + spans_[farthest[i]];
}

std::size_t SpansToEnd::first_within(std::size_t spans) const {
  const auto first = std::ranges::partition_point(spans_, [spans](std::size_t n) { return n > spans; });
  return static_cast<std::size_t>(first - spans_.begin());
}

}}  // namespace orispline
