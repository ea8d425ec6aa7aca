// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Eigen::Affine3d transform(const JointPose& pose) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = pose.rotation.toRotationMatrix() * pose.scale.asDiagonal();
  transform.translation() = pose.translation;
  return transform;
}

}  // namespace

ClipMotion::ClipMotion(const Skeleton& skeleton, const Clip& clip)
    : skeleton_(&skeleton),
      rotations_(clip.rotations.begin(), clip.rotations.end()),
      translations_(clip.translations.begin(), clip.translations.end()),
      scales_(clip.scales.begin(), clip.scales.end()),
      places_(skeleton.size()) {
  for (std::size_t i = 0; i < rotations_.size(); ++i) places_[rotations_[i].joint()].rotation = i + 1;
  for (std::size_t i = 0; i < translations_.size(); ++i) places_[translations_[i].joint()].translation = i + 1;
  for (std::size_t i = 0; i < scales_.size(); ++i) places_[scales_[i].joint()].scale = i + 1;
}

JointPose ClipMotion::local_pose(std::size_t joint, double t) const noexcept {
  JointPose pose = (*skeleton_)[joint].rest;
  const Places& places = places_[joint];
  if (places.rotation) pose.rotation = rotations_[places.rotation - 1].at(t);
  if (places.translation) pose.translation = translations_[places.translation - 1].at(t);
  if (places.scale) pose.scale = scales_[places.scale - 1].at(t);
  return pose;
}

void ClipMotion::world_poses(double t, std::span<Eigen::Affine3d> poses) const noexcept {
  for (std::size_t i = 0; i < skeleton_->size(); ++i) {
    poses[i] = transform(local_pose(i, t));
    if (const std::size_t parent = (*skeleton_)[i].parent; parent != no_parent) poses[i] = poses[parent] * poses[i];
  }
}

std::vector<Eigen::Affine3d> world_poses(const Skeleton& skeleton, const Clip& clip, std::span<const double> times) {
  const ClipMotion motion(skeleton, clip);
  std::vector<Eigen::Affine3d> poses(skeleton.size() * times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    motion.world_poses(times[i], std::span(poses).subspan(i * skeleton.size(), skeleton.size()));
  return poses;
}

}}  // namespace orispline
