// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Frames in a row in which joints are somewhere else: a swapped limb, a marker that was taken for another, a hold.
struct WrongRun {
  std::vector<std::size_t> joints{};  ///< rising
  std::size_t first = 0, count = 0;   ///< keys of their rotations
  double start = 0.0, end = 0.0;      ///< times of the first and the last of them [s]
  double jump = 0.0;                  ///< the largest by which one of them goes away or back [rad]
};

/// So many frames in a row; fewer are outliers of one track, more are motion.
inline constexpr std::size_t shortest_run = 3, longest_run = 30;
/// A jump turns by this at least [rad].
inline constexpr double least_jump = 0.05;

/// The runs of a clip, by their first frames. A joint jumps from one frame to the next where its turn differs from the
/// median of those beside it by four times as much as any other within 8 frames; a run goes away by one jump and comes
/// back by another, to where the motion before leads, or holds still and catches up. Joints above and below one with a
/// run take part in it from 1.3 times on. Where nearly all that move take part, it is a cut and no fault.
///
/// `linear` rotations with the same key times are seen together; those of fewer than `fewest_smoothed_keys` have none.
[[nodiscard]] ORISPLINE_EXPORT std::vector<WrongRun> wrong_runs(const Skeleton& skeleton, const Clip& clip);

}}  // namespace orispline
