// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/reduce/span_check.hpp>
#include <orispline/reduce/tolerance_check.hpp>

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

/// Which way spans from a sample go.
enum class SpanDirection { to_end, to_start };

/// How far spans within the tolerance may go from each sample, at most: the index of the last sample that is not ruled
/// out, in that direction.
///
/// No span from sample i goes to sample k or beyond where the rates that pass the samples up to k are none
/// (FeasibleRates). Two samples mostly prove that, and prove it for the next sample's spans as well.
[[nodiscard]] std::vector<std::size_t> farthest_of_spans(const ToleranceCheck& recording, const WitnessSamples& telling,
                                                         SpanDirection direction);

}}  // namespace orispline
