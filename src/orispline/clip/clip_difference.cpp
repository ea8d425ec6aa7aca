// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_difference.hpp>

#include <algorithm>
#include <set>

#include <orispline/math/highest.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double angle_between(const JointPose& a, const JointPose& b) { return angular_distance(a.rotation, b.rotation); }

double translation_between(const JointPose& a, const JointPose& b) { return (a.translation - b.translation).norm(); }

/// The joints of two motions, each beside its counterpart.
struct JointsBeside {
  const ClipMotion &first, &second;
  std::span<const std::size_t> counterparts;
  double shell;

  [[nodiscard]] double angle(std::size_t joint, double t) const {
    return angle_between(first.local_pose(joint, t), second.local_pose(counterparts[joint], t));
  }
  [[nodiscard]] double translation(std::size_t joint, double t) const {
    return translation_between(first.local_pose(joint, t), second.local_pose(counterparts[joint], t));
  }
  [[nodiscard]] double distance(std::size_t joint, double t) const {
    return shell_distance(first.world_pose(joint, t), second.world_pose(counterparts[joint], t), shell);
  }

  /// Passes the differences of every joint that has a counterpart to take(joint, time, angle, translation, distance).
  template <class Take>
  void pass(std::span<const double> times, const Take& take) const {
    std::vector<JointPose> poses(counterparts.size()), others(second.skeleton().size());
    std::vector<Eigen::Affine3d> places(poses.size()), other_places(others.size());
    for (const double t : times) {
      first.poses(t, poses, places);
      second.poses(t, others, other_places);
      for (std::size_t i = 0; i < counterparts.size(); ++i) {
        const std::size_t other = counterparts[i];
        if (other == no_parent) continue;
        take(i, t, angle_between(poses[i], others[other]), translation_between(poses[i], others[other]),
             shell_distance(places[i], other_places[other], shell));
      }
    }
  }

  [[nodiscard]] std::vector<JointDifference> at(std::span<const double> times) const {
    const LargestInTime none{.time = times.front()};
    std::vector<JointDifference> found(counterparts.size(), {none, none, none});
    pass(times, [&](std::size_t joint, double t, double angle, double translation, double distance) {
      found[joint].angle.take(angle, t);
      found[joint].translation.take(translation, t);
      found[joint].distance.take(distance, t);
    });
    return found;
  }

  [[nodiscard]] std::vector<JointDifference> around(std::span<const double> times, Between between) const {
    struct Summits {
      SummitsInPassing angle, translation, distance;
    };
    std::vector<Summits> summits(counterparts.size());
    pass(times, [&](std::size_t joint, double t, double angle, double translation, double distance) {
      summits[joint].angle.pass({t, angle});
      summits[joint].translation.pass({t, translation});
      summits[joint].distance.pass({t, distance});
    });
    const auto known = [&](SummitsInPassing Summits::*of) {
      double passed = 0.0;
      if (between == Between::looked_at_for_largest)
        for (const Summits& joint : summits) passed = std::max(passed, (joint.*of).highest_passed().value);
      return passed;
    };
    double angle_known = known(&Summits::angle), translation_known = known(&Summits::translation),
           distance_known = known(&Summits::distance);
    const auto largest = [&](SummitsInPassing& passed, double& largest_known, const auto& f) {
      const Height top = passed.highest(f, largest_known);
      if (between == Between::looked_at_for_largest) largest_known = std::max(largest_known, top.value);
      return LargestInTime{.value = top.value, .time = top.place};
    };
    const LargestInTime none{.time = times.front()};
    std::vector<JointDifference> found(counterparts.size(), {none, none, none});
    for (std::size_t i = 0; i < counterparts.size(); ++i) {
      if (counterparts[i] == no_parent) continue;
      auto& [angles, translations, distances] = summits[i];
      found[i] = {.angle = largest(angles, angle_known, [&](double t) { return angle(i, t); }),
                  .translation = largest(translations, translation_known, [&](double t) { return translation(i, t); }),
                  .distance = largest(distances, distance_known, [&](double t) { return distance(i, t); })};
    }
    return found;
  }
};

/// Those that channels share count once.
template <CurvePoint P>
void append_times(std::vector<double>& times, std::set<const double*>& taken, const std::vector<Channel<P>>& channels) {
  for (const Channel<P>& channel : channels)
    if (taken.insert(channel.times.data()).second)
      times.insert(times.end(), channel.times.begin(), channel.times.end());
}

}  // namespace

double shell_distance(const Eigen::Affine3d& a, const Eigen::Affine3d& b, double shell) {
  const Eigen::Vector3d shift = a.translation() - b.translation();
  const Eigen::Matrix3d turn = shell * (a.linear() - b.linear());
  double square = shift.squaredNorm();
  for (Eigen::Index axis = 0; axis < 3; ++axis) square = std::max(square, (shift + turn.col(axis)).squaredNorm());
  return std::sqrt(square);
}

std::vector<JointDifference> differences(const ClipMotion& first, const ClipMotion& second,
                                         std::span<const std::size_t> counterparts, std::span<const double> times,
                                         double shell, Between between) {
  const JointsBeside beside{first, second, counterparts, shell};
  return between == Between::nothing ? beside.at(times) : beside.around(times, between);
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
