// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/curve/path.hpp>

// Two clips one after the other.

namespace orispline { inline namespace ORISPLINE_ABI {

/// How two clips are joined.
struct JoinOptions {
  double blend = 0.2;            ///< how long one goes over into the other [s]
  std::size_t root = no_parent;  ///< whose place and heading go on; `no_parent`: the first joint that travels
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< of the world
};

/// Two clips as one, and where they meet.
struct JoinedClip {
  Clip clip{};
  Domain blend{0.0, 0.0};  ///< when one goes over into the other [s]
  double turn = 0.0;       ///< of the second one about up [rad]
};

/// The clip of another file as one of this skeleton. Joints go by counterparts_of().
///
/// Errors (bad_data), which name the joint: one that moves in either clip, or one above it, which the other skeleton
/// has not or has in another rest pose.
[[nodiscard]] ORISPLINE_EXPORT Expected<Clip> with_joints_of(const Skeleton& skeleton, const Clip& clip,
                                                             const Skeleton& other, const Clip& of_other);

/// The first clip, then the second, over the last `blend` seconds of the one and the first of the other. The second is
/// turned about up and moved across it so that the root is where that of the first one is, in the middle of the
/// blend: all that goes somewhere, by the highest joints that move. What has no moving translation stays in its place.
///
/// There each channel is the geodesic from one motion to the other, with a share that is a quintic in time: at both
/// ends value, rate and acceleration are those of the clip that goes on. A joint that moves in one clip alone rests in
/// the other. Steps change in the middle. Errors (bad_argument of `blend`): longer than one of the clips; those of the
/// curves through the keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<JoinedClip> joined(const Skeleton& skeleton, const Clip& first,
                                                           const Clip& second, const JoinOptions& options = {});

/// From one curve to another over a stretch of time that both have.
[[nodiscard]] ORISPLINE_EXPORT AnyCurve blended(const AnyCurve& from, const AnyCurve& to, Domain over);
[[nodiscard]] ORISPLINE_EXPORT AnyPath blended(const AnyPath& from, const AnyPath& to, Domain over);

}}  // namespace orispline
