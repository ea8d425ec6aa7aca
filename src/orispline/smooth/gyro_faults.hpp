// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/smooth/gyro_alignment.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Takes from `counts` the rates of a gyro that are wrong, and returns whether there were any.
///
/// Single ones and pairs far from the rate of the orientations; runs that are far over one of several lags and across
/// which the orientations turn otherwise than the integrated rates, both in units of the median over the recording, so
/// that a run of up to a tenth of it does not hide itself; zeros in all three axes amid a motion; and rates that stay
/// at their largest absolute value while the orientations turn faster.
bool leave_out_faults(const SeenPoses& poses, const GyroRates& gyro, const GyroAlignment& alignment,
                      CountedRates& counts);

/// Error (bad_data): as the rates of one clock are, they agree with the orientations under another meaning, which it
/// says.
[[nodiscard]] Expected<void> check_frame(const SeenPoses& poses, const GyroRates& gyro);

/// Whether a gyro measures the motion of the orientations. Error (bad_data): with that offset [s] its rates agree with
/// them under another meaning, or it turns many times as fast, or against them.
[[nodiscard]] Expected<void> check_meaning(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                           double offset);

}}  // namespace orispline
