// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_motion.hpp>

// Where a clip takes a joint in the world, across the up axis and about it.

namespace orispline { inline namespace ORISPLINE_ABI {

/// A joint, and those above it that the clip moves: what a character's way may be in.
[[nodiscard]] std::vector<std::size_t> carriers_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint);

/// Where a joint is in the world, and how it is turned there: its own scale is left out, that of those above it is not.
[[nodiscard]] Eigen::Affine3d placed(const ClipMotion& moving, std::size_t joint, double t);
/// From one such frame to another one about up, within a half turn either way [rad].
[[nodiscard]] double heading_between(const Eigen::Vector3d& up, const Eigen::Affine3d& before,
                                     const Eigen::Affine3d& after);

/// From the start of a clip to its end.
struct Travel {
  double way = 0.0;   ///< as far as it comes across up, in the unit of lengths
  double turn = 0.0;  ///< about up [rad]; whole rounds count
};
[[nodiscard]] ORISPLINE_EXPORT Travel travel_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint,
                                                const Eigen::Vector3d& up);

}}  // namespace orispline
