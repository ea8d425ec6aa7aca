// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/clip/motion_file.hpp>

// Where a joint goes and where it heads, taken out of it.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whose motion is taken, and where it goes.
struct RootMotion {
  std::size_t joint = no_parent;                  ///< whose travel across up and heading about up are taken
  std::size_t node = no_parent;                   ///< above it, which gets them; `no_parent`: nobody, it stays in place
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< of the world
};

/// The clip with the way of a joint, from where it is at the start, in another node or nowhere: with G(t) that way, a
/// turn about up and a shift across it, the joint is at G⁻¹ W where it was at W in the world, and the node at G N where
/// it was at N, so that the joint is at W again.
///
/// Rotation and translation of both become linear, with keys where any joint from the root to this one has some, and
/// between these where a straight line is off by more than 1e-4 rad or 1e-4 of the way. Errors (bad_data), which name
/// the joint: a node that is not above it; a scale above it that is not the same along all axes.
[[nodiscard]] ORISPLINE_EXPORT Expected<Clip> with_root_motion(const Skeleton& skeleton, const Clip& clip,
                                                               const RootMotion& motion);

/// The file with one joint more, the first one, above a joint without a parent: it rests at the origin of the world,
/// and is called `root`, or that with as many `_` as no other joint has.
[[nodiscard]] ORISPLINE_EXPORT Expected<MotionFile> with_root_above(MotionFile file, std::size_t joint);

/// The topmost joint above another one; `no_parent` where there is none.
[[nodiscard]] ORISPLINE_EXPORT std::size_t topmost_above(const Skeleton& skeleton, std::size_t joint) noexcept;

}}  // namespace orispline
