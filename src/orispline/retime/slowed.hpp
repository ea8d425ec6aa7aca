// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/retime/limited_motion.hpp>

// How slow a motion has to be.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Times at which the motion keeps its limits, as in Retiming.
struct Slowed {
  std::vector<double> times;
  double time_scale, slack;
  Slowing slowing;
  std::vector<SegmentPeaks> peaks;
};

/// At its own times, of which nothing is asked.
[[nodiscard]] Slowed as_given(const LimitedMotion& motion);

/// The least slowing, of the two where both are asked for. `support_keys`: of the method. Errors: those of retime().
[[nodiscard]] Expected<Slowed> least_slowed(const LimitedMotion& motion, int support_keys, Slowing slowing);

/// Exactly that long, all intervals but rests scaled alike. Error (bad_argument): the rests alone are longer; a limit
/// is exceeded then.
[[nodiscard]] Expected<Slowed> lasting(const LimitedMotion& motion, double duration);

/// To the six digits that are shown: shown rounded down it would not do.
[[nodiscard]] double as_shown_or_more(double seconds);

inline constexpr double promised_slack = 2e-4;  // more is worth a warning
[[nodiscard]] Warning loose_bounds(std::string_view method, double slack);
[[nodiscard]] Warning longer_rests(std::string_view method);

inline constexpr double least_gain = 1e-4;   // of the duration, to which the slowing is the least one, for another path
inline constexpr double usual_rounds = 3.0;  // of slowing all alike
inline constexpr double ways_down = 3.0;     // of the fastest keys

}}  // namespace orispline
