// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/travel.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include <orispline/clip/clip_difference.hpp>
#include <orispline/edit/channel_path.hpp>
#include <orispline/edit/up_axis.hpp>
#include <orispline/math/rotation_matrix.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int looks_per_step = 4;  // from key to key, so that no step between two of them is a half turn

}  // namespace

std::vector<std::size_t> carriers_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint) {
  std::vector<std::size_t> carriers{joint};
  const auto moves = [](const auto* channel) { return channel && !rests(*channel); };
  for (std::size_t above = skeleton[joint].parent; above != no_parent; above = skeleton[above].parent)
    if (moves(channel_of(clip.rotations, above)) || moves(channel_of(clip.translations, above)))
      carriers.push_back(above);
  return carriers;
}

Eigen::Affine3d placed(const ClipMotion& moving, std::size_t joint, double t) {
  const std::size_t parent = moving.skeleton()[joint].parent;
  const JointPose pose = moving.local_pose(joint, t);
  const Eigen::Affine3d own = Eigen::Translation3d(pose.translation) * pose.rotation;
  return parent == no_parent ? own : moving.world_pose(parent, t) * own;
}

double heading_between(const Eigen::Vector3d& up, const Eigen::Affine3d& before, const Eigen::Affine3d& after) {
  const Eigen::Matrix3d step = after.linear() * before.linear().inverse(), unit = step / step.col(0).norm();
  return unit.allFinite() ? heading_of(up, quaternion_from_matrix(unit).normalized()) : 0.0;
}

Travel travel_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint, const Eigen::Vector3d& up) {
  const ClipMotion moving(skeleton, clip);
  const std::vector<double> times = key_times(clip);
  if (times.empty()) return {};
  const Eigen::Affine3d start = placed(moving, joint, times.front());
  Eigen::Affine3d last = start;
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (int k = 1; k <= looks_per_step; ++k) {
      const Eigen::Affine3d next = placed(moving, joint, times[i] + (times[i + 1] - times[i]) * k / looks_per_step);
      sum += heading_between(up, last, next);
      last = next;
    }
  // Turns about leaning axes do not add up to the whole one; they say how many rounds it has.
  const double turn = heading_between(up, start, last), round = 2.0 * std::numbers::pi;
  const Eigen::Vector3d way = last.translation() - start.translation();
  return {(way - up * up.dot(way)).norm(), turn + round * std::round((sum - turn) / round)};
}

}}  // namespace orispline
