// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/seam.hpp>

#include <algorithm>

#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

ClipSeam seam_of(const Clip& clip, std::span<const JointTurn> turns) {
  ClipSeam seam;
  const auto take = [](ClipSeam::Step& step, double value, std::size_t joint) {
    if (value > step.value) step = {value, joint};
  };
  const Domain domain = clip.domain();
  for (const RotationChannel& channel : clip.rotations) {
    if (channel.size() == 1) continue;
    const ChannelCurve<Eigen::Quaterniond> curve(channel);
    const Motion start = curve.motion(domain.start), end = curve.motion(domain.end);
    const auto turned = std::ranges::find(turns, channel.joint, &JointTurn::joint);
    const Eigen::Quaterniond again = turned == turns.end() ? start.orientation : turned->turn * start.orientation;
    take(seam.pose, angular_distance(end.orientation, again), channel.joint);
    take(seam.rate, (start.angular_velocity - end.angular_velocity).norm(), channel.joint);
  }
  return seam;
}

}}  // namespace orispline
