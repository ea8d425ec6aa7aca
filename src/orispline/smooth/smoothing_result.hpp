// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What is to be said about it; `warnings` themselves play no part.
///
/// `outliers_followed`, before all others: so many `samples` were kept that are as far as those that are rejected,
/// which are many, so that they may be faults that come side by side; `least_smoothing`: hardly any noise beside the
/// motion; `most_smoothing`: no change of the rates beside the noise; `rejected_run`: so many `samples` in a row do not
/// count, which is rather motion than outliers; `many_rejected`: so many `samples` in all, more than one in a hundred;
/// `many_positions_rejected`: the same of positions; `unfinished`: the last step of the iteration still moved by
/// `step_rad`; `short_for_its_noise`: the recording holds so few of the times over which noise correlates that the
/// error may be anything from `least_rad` to `most_rad`; `gyro_left_out`: the orientations come out better without the
/// gyro; `noise_contradicted`: beside a gyro the residuals of the orientations are not those of the stated noise.
[[nodiscard]] std::vector<Warning> warnings_of(const Smoothing& smoothing, const SmoothOptions& options = {});

/// `jumps_followed`: so many `samples` that are far, but were kept, turn by more than 90° from the one before.
[[nodiscard]] std::optional<Warning> jumps_followed(const Smoothing& smoothing, const Keyframes& recording);

/// From the nodes to the recording that they smooth: to all samples, or to those that are not rejected.
enum class CountedSamples { all, accepted };
[[nodiscard]] SampleDistances distances_of(const Smoothing& smoothing, const Keyframes& recording,
                                           CountedSamples which);
/// Of the positions [m]. Precondition: there are some.
[[nodiscard]] SampleDistances position_distances_of(const Smoothing& smoothing, const Keyframes& recording,
                                                    CountedSamples which);

}}  // namespace orispline
