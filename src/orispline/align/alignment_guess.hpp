// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/align/alignment_fit.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What suits an offset of the clocks, near enough for fit_alignment() to begin with: rotations from the turns in equal
/// intervals, then scale and translation from where the middles of the positions lie. A tenth of bad samples does not
/// move it far. `interval` [s]: no shorter than samples of either recording are apart. None where the recordings
/// overlap by fewer than `least_aligned` intervals.
[[nodiscard]] std::optional<Transform> guess_alignment(const AlignmentData& data, const AnyCurve& fixed,
                                                       double interval, double offset);

}}  // namespace orispline
