// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A joint of a clip that was smoothed by itself.
struct SmoothedJoint {
  const RotationChannel* rotation;   ///< as recorded, with the key times
  const VectorChannel* translation;  ///< at the same times, which was smoothed with it; null without one
  Smoothing* smoothing;              ///< with a node for every key
};

/// Fewer joints, or key times, tell too little of how they move together.
inline constexpr std::size_t fewest_joints_together = 6, fewest_times_together = 60;

/// Whether joints with these key times are enough, and the times even.
[[nodiscard]] bool can_be_smoothed_together(std::size_t joints, std::span<const double> times);

/// Whether these options leave it open how smooth the joints are.
[[nodiscard]] bool are_smoothed_together(const SmoothOptions& options);

/// Smooths joints with the same key times once more, all together: by the shared_motion() of their turns and places,
/// about the motion that each has by itself. Samples that were rejected stand where that motion is. The noise of each
/// joint, its time of correlation and the smoothing time that its motion alone would have are those found here.
///
/// Nothing happens where they cannot.
void smooth_together(const std::vector<SmoothedJoint>& joints, const SmoothOptions& options);

}}  // namespace orispline
