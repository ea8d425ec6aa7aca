// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A clip at later times, which all its channels share.
struct ClipRetiming {
  Clip clip{};
  double time_scale = 1.0;            ///< of the whole duration; below 1 only where intervals got shorter
  double slack = 0.0;                 ///< by which share less slowing might do
  Slowing slowing{};                  ///< how the intervals were slowed
  std::vector<SegmentPeaks> peaks{};  ///< of the slowed motion; their bodies are joints
  std::size_t rests = 0;              ///< intervals in which all joints rest
  std::size_t measured = 0;           ///< cubic channels, whose peaks are measured and not bounds
  std::vector<Warning> warnings{};    ///< `loose_bounds`, `longer_rests`, `measured_peaks`
};

/// Options that a clip is not retimed by. Errors (bad_argument): those of check(); a torque, an even motion, keys
/// inserted.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_for_clips(const RetimeOptions& options);

/// The least slowing with which every joint of a clip stays within the limits, as seen from its parent, by one new
/// clock for all of them: retime() of several bodies at once. Limits of rates are of rotations, those of speeds of
/// translations in the unit of the skeleton.
///
/// The motion of a linear channel, whose keys are samples, is the method's curve through them; that of a cubic is the
/// cubic, whose peaks are measured at 17 places of each segment. Intervals by themselves, and rests cut, want linear
/// channels with the same key times. Steps and single keys move nothing. Errors, which name the clip: those of retime()
/// and check_for_clips(); bad_data for a clip that has no duration.
[[nodiscard]] ORISPLINE_EXPORT Expected<ClipRetiming> retime_clip(const Skeleton& skeleton, const Clip& clip,
                                                                  const Method& method, const RetimeOptions& options,
                                                                  const Progress& progress = {});

}}  // namespace orispline
