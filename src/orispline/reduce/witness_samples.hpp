// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/reduce/span_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which samples are worth a look to find out how far spans go: about 16 for every doubling of the distance, those that
/// are farthest from the geodesics fitted to their blocks, for they forbid most.
class WitnessSamples {
 public:
  WitnessSamples(const SpanTest& spans, std::size_t size);

  /// The one to look at after sample `looked` for spans from sample i; the last (the first) sample
  /// where there is no other.
  [[nodiscard]] std::size_t after(std::size_t i, std::size_t looked) const;
  [[nodiscard]] std::size_t before(std::size_t i, std::size_t looked) const;

 private:
  [[nodiscard]] const std::vector<std::size_t>* at_distance(std::size_t distance) const;

  std::size_t size_;
  std::vector<std::vector<std::size_t>> levels_;  ///< rising, of blocks of 2, 4, 8 … intervals
};

}}  // namespace orispline
