// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>
#include <orispline/curve/pose_curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a joint's motion is seen from.
enum class JointSpace {
  local,  ///< the frame of its parent
  world,
};

/// The motion of one joint as its clip says it, with exact rates: its knots are the keys of the channels that move it.
///
/// Errors (bad_data): in the world, a scale above the joint that is negative or not the same along all axes, below
/// which there is no orientation.
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> joint_curve(const Skeleton& skeleton, const Clip& clip,
                                                               std::size_t joint, JointSpace space);

}}  // namespace orispline
