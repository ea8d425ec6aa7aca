// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_difference.hpp>

#include <algorithm>
#include <set>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double shell_distance(const Eigen::Affine3d& a, const Eigen::Affine3d& b, double shell) {
  const Eigen::Vector3d shift = a.translation() - b.translation();
  const Eigen::Matrix3d turn = shell * (a.linear() - b.linear());
  double square = shift.squaredNorm();
  for (Eigen::Index axis = 0; axis < 3; ++axis) square = std::max(square, (shift + turn.col(axis)).squaredNorm());
  return std::sqrt(square);
}

/// Those that channels share count once.
template <CurvePoint P>
void append_times(std::vector<double>& times, std::set<const double*>& taken, const std::vector<Channel<P>>& channels) {
  for (const Channel<P>& channel : channels)
    if (taken.insert(channel.times.data()).second)
      times.insert(times.end(), channel.times.begin(), channel.times.end());
}

}  // namespace

std::vector<JointDifference> differences(const ClipMotion& first, const ClipMotion& second,
                                         std::span<const std::size_t> counterparts, std::span<const double> times,
                                         double shell) {
  const std::size_t joints = first.skeleton().size();
  std::vector<Eigen::Affine3d> poses(joints), others(second.skeleton().size());
  const LargestInTime none{.time = times.front()};
  std::vector<JointDifference> found(joints, {none, none, none});
  for (const double t : times) {
    first.world_poses(t, poses);
    second.world_poses(t, others);
    for (std::size_t i = 0; i < joints; ++i) {
      const std::size_t other = counterparts[i];
      if (other == no_parent) continue;
      const JointPose a = first.local_pose(i, t), b = second.local_pose(other, t);
      JointDifference& worst = found[i];
      worst.angle.take(angular_distance(a.rotation, b.rotation), t);
      worst.translation.take((a.translation - b.translation).norm(), t);
      worst.distance.take(shell_distance(poses[i], others[other], shell), t);
    }
  }
  return found;
}

std::vector<double> key_times(const Clip& clip) {
  std::vector<double> times;
  std::set<const double*> taken;
  append_times(times, taken, clip.rotations);
  append_times(times, taken, clip.translations);
  append_times(times, taken, clip.scales);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}}  // namespace orispline
