// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/retime/limited_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Times [s] of the keys at which the motion keeps its limits, but for a little that is left to one factor, and takes
/// little longer than it must: no interval is shorter than its least.
///
/// From `times` on, intervals that break a limit are stretched, round after round. From there on, for methods whose
/// segments depend on `support_keys` near keys, Σ h_i − μ Σ_s w_s (log(1 − f_s) + log h_s) goes down coordinate by
/// coordinate, a barrier method: f_s is the factor that segment s needs, w_s its length, and μ 0.1, 0.01, 0.001 and at
/// last 0, as long as a sweep over all intervals gains 1e-4 of the duration. Intervals that no segment shares are moved
/// at once. Source: our own, docs/retime.md. Error: that of a curve which cannot be made.
[[nodiscard]] Expected<std::vector<double>> least_interval_times(const LimitedMotion& motion, std::vector<double> times,
                                                                 int support_keys);

/// About how many curves that takes.
[[nodiscard]] double curves_for_interval_times(int support_keys) noexcept;

}}  // namespace orispline
