// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rate_bounds.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which intervals between keys are slowed.
enum class Slowing {
  uniform,      ///< all by one factor s: the same path, ω/s and α/s² everywhere
  per_interval  ///< each by its own: the method's curve through the keys at their new times
};

/// What a motion shall keep, and how it may be slowed for it.
struct RetimeOptions {
  MotionLimits limits{};
  Slowing slowing = Slowing::uniform;
  std::optional<double> duration{};       ///< [s], from the first key to the last; the limits are checked then
  std::optional<double> shorten_rests{};  ///< [s], what longer rests are cut to; absent: rests keep their duration
};

/// Keys at later times.
struct Retiming {
  Track track{};                      ///< the one given at the new times, the first as it was
  Method method{};                    ///< the one given, with the settings of the track
  double time_scale = 1.0;            ///< of the whole duration; below 1 only where rests were shortened
  double slack = 0.0;                 ///< by which share less slowing might do: what was found is below the limits
  Slowing slowing{};                  ///< how they were slowed: uniformly where intervals by themselves take longer
  std::vector<SegmentPeaks> peaks{};  ///< of the slowed curve, segment by segment: no bound above its limit
  std::vector<std::size_t> rests{};   ///< i where the body rests from key i to the next
  std::vector<Warning>
      warnings{};  ///< `loose_bounds`, `moving_rests`, `longer_rests`; of the inertia, and of the method's curve
};

/// The method for keys of which nobody said which curve they are for: the one given, with `hold` where it has that
/// setting, it is not stated and some of the keys are rests (Keyframes::rests_after), so that the body stays in them.
[[nodiscard]] ORISPLINE_EXPORT Method holding_rests(Method method, const Keyframes& keys);

/// Error (bad_argument): limits that are absent or not greater than 0, a torque without a positive definite inertia and
/// an inertia without a torque.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const RetimeOptions& options);

/// The least slowing, to 1e-4, with which the method's curve through the keys stays within the limits everywhere. Where
/// the largest values found are farther than 2e-4 below the limits, a warning says so: `loose_bounds` (`slack`).
///
/// Certified by certified_peaks() on the method's curve, with its settings and those of the track, through the keys at
/// the times that are returned. A motion within the limits stays as it is. Rests keep their duration, or the one that
/// `shorten_rests` states; a method that moves during them is warned of: `moving_rests` (`rests`). Where the limits
/// cannot be met that way, rests are slowed as well: `longer_rests`. `per_interval`
/// shortens the whole duration as far as least_interval_times() finds a way, for methods that are not local less far;
/// it is the uniform slowing where that is the shorter, or longer by less than 1e-4. The curve is as smooth as the
/// method makes it. Positions, where there are any, play no part. Errors: those of check(); bad_argument for limits
/// that ask for more than 1e15 times the duration, a method that takes rates from the keys, does not state its segments
/// as polynomials, or whose ω jumps on these keys where acceleration is limited: no slowing helps; the like for
/// `per_interval` of a method whose ω is continuous on even times only; loops, and rates at the ends other than zero,
/// which slowing would change; bad_data for fewer than two keys; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Retiming> retime(const Track& track, const Method& method,
                                                         const RetimeOptions& options, const Progress& progress = {});

}}  // namespace orispline
