// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/seam.hpp>

#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

ClipSeam seam_of(const Clip& clip, std::size_t root, const Eigen::Quaterniond& turn) {
  ClipSeam seam;
  const auto take = [](ClipSeam::Step& step, double value, std::size_t joint) {
    if (value > step.value) step = {value, joint};
  };
  const Domain domain = clip.domain();
  for (const RotationChannel& channel : clip.rotations) {
    if (channel.size() == 1) continue;
    const ChannelCurve<Eigen::Quaterniond> curve(channel);
    const Motion start = curve.motion(domain.start), end = curve.motion(domain.end);
    const Eigen::Quaterniond again = channel.joint == root ? turn * start.orientation : start.orientation;
    take(seam.pose, angular_distance(end.orientation, again), channel.joint);
    take(seam.rate, (start.angular_velocity - end.angular_velocity).norm(), channel.joint);
  }
  return seam;
}

}}  // namespace orispline
