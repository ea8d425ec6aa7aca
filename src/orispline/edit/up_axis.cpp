// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/up_axis.hpp>

#include <Eigen/LU>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

double heading_of(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rotation) noexcept {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  return 2.0 * atan2_of(sign * rotation.vec().dot(axis), sign * rotation.w());
}

Eigen::Vector3d up_in_parent(const Skeleton& skeleton, const Clip& clip, std::size_t joint, const Eigen::Vector3d& up) {
  const std::size_t parent = skeleton[joint].parent;
  if (parent == no_parent) return up;
  const Eigen::Matrix3d frame = ClipMotion(skeleton, clip).world_pose(parent, clip.domain().start).linear();
  return (frame.inverse() * up).normalized();
}

}}  // namespace orispline
