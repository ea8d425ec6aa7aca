// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How many spans a chain from a sample to the last one has at least. Later samples never have more.
class SpansToEnd {
 public:
  /// From the last sample that a span from each sample may reach.
  explicit SpansToEnd(std::vector<std::size_t> farthest);

  [[nodiscard]] std::size_t at_least(std::size_t sample) const { return spans_[sample]; }
  /// The first sample from which that many spans may be enough.
  [[nodiscard]] std::size_t first_within(std::size_t spans) const;

 private:
  std::vector<std::size_t> spans_;
};

}}  // namespace orispline
