// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether a gyro measures the motion of the orientations: samples of it that do not count, faults of one or two in a
/// row, far from the rates of a fit without it.
///
/// Error (bad_data): the gyro turns many times as fast as the orientations, or against them; where the rates agree
/// under another meaning it says which.
[[nodiscard]] Expected<std::vector<std::size_t>> gyro_faults(const StretchFits& fits, const Keyframes& recording,
                                                             const std::vector<Stretch>& stretches);

}}  // namespace orispline
