// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The angle of a rotation about an axis of unit length, within a half turn either way [rad]: the twist of its
/// decomposition into a swing of the axis and a twist about it.
[[nodiscard]] double heading_of(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rotation) noexcept;

/// The unit vector that is up in the world, in the frame of a joint's parent at the start of the clip.
[[nodiscard]] Eigen::Vector3d up_in_parent(const Skeleton& skeleton, const Clip& clip, std::size_t joint,
                                           const Eigen::Vector3d& up);

}}  // namespace orispline
