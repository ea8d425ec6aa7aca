// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/reduce/tolerance_check.hpp>
#include <orispline/reduce/witness_samples.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
