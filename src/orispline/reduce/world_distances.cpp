// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/world_distances.hpp>

#include <algorithm>

#include <orispline/clip/clip_difference.hpp>
#include <orispline/math/highest.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t most_places = std::size_t{1} << 19;  // that are remembered: 64 MB

template <CurvePoint P>
bool is_same(const Channel<P>& a, const Channel<P>& b) {
  if (a.size() == 1 && b.size() == 1) return a.values == b.values;
  return places_of_keys(a) == places_of_keys(b);
}

}  // namespace

WorldDistances::WorldDistances(const Skeleton& skeleton, const TakenClip& taken, double shell, bool again)
    : skeleton_(skeleton),
      taken_(taken),
      shell_(shell),
      motion_(skeleton, taken.rotations, taken.translations, taken.scales),
      known_(known_poses()),
      scratch_(skeleton.size()),
      most_remembered_(again ? most_places / std::max<std::size_t>(skeleton.size(), 1) : 0) {}

std::vector<WorldDistances::KnownPose> WorldDistances::known_poses() const {
  std::vector<KnownPose> poses(skeleton_.size());
  const auto note = [&](const auto& channels, const auto& looks, auto KnownPose::*part) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (channels[i].size() == 1) continue;
      KnownPose& pose = poses[channels[i].joint];
      const bool has_all = looks[i].size() == taken_.times.size() &&
                           channels[i].times.front() == taken_.times.front() &&
                           with_looks_between(channels[i].times) == taken_.times;
      if (has_all) pose.*part = looks[i].data();
      else pose.is_known = false;
    }
  };
  note(taken_.clip.rotations, taken_.rotation_looks, &KnownPose::rotations);
  note(taken_.clip.translations, taken_.translation_looks, &KnownPose::translations);
  for (const VectorChannel& channel : taken_.clip.scales)
    if (channel.size() > 1) poses[channel.joint].is_known = false;
  return poses;
}

void WorldDistances::place(std::size_t k, std::span<Eigen::Affine3d> world) const {
  for (std::size_t i = 0; i < skeleton_.size(); ++i) {
    const KnownPose& known = known_[i];
    JointPose pose = known.is_known ? motion_.still_pose(i) : motion_.local_pose(i, taken_.times[k]);
    if (known.is_known && known.rotations) pose.rotation = known.rotations[k];
    if (known.is_known && known.translations) pose.translation = known.translations[k];
    world[i] = motion_.placed(i, pose, world);
  }
}

std::span<const Eigen::Affine3d> WorldDistances::remembered(std::size_t k) {
  const std::size_t joints = skeleton_.size();
  if (k >= most_remembered_) {
    place(k, scratch_);
    return scratch_;
  }
  for (; times_remembered_ <= k; ++times_remembered_) {
    remembered_.resize((times_remembered_ + 1) * joints);
    place(times_remembered_, std::span(remembered_).subspan(times_remembered_ * joints));
  }
  return std::span(remembered_).subspan(k * joints, joints);
}

std::vector<bool> WorldDistances::may_be_apart(const Clip& after) const {
  std::vector<bool> apart(skeleton_.size());
  const auto note = [&](const auto& channels, const auto& fewer) {
    for (std::size_t i = 0; i < channels.size(); ++i)
      if (!is_same(channels[i], fewer[i])) apart[channels[i].joint] = true;
  };
  note(taken_.clip.rotations, after.rotations);
  note(taken_.clip.translations, after.translations);
  note(taken_.clip.scales, after.scales);
  for (std::size_t i = 0; i < skeleton_.size(); ++i)
    if (const std::size_t parent = skeleton_[i].parent; parent != no_parent && apart[parent]) apart[i] = true;
  return apart;
}

ClipReduction::Worst WorldDistances::farthest(const Clip& after) {
  const std::size_t joints = skeleton_.size();
  const bool is_as_taken = taken_.is_beside_as_taken(after);
  const ClipMotion first = is_as_taken ? motion_ : taken_.beside(skeleton_, after), second(skeleton_, after);
  const std::vector<bool> is_apart = may_be_apart(after);
  std::vector<Eigen::Affine3d> places(joints), others(joints);
  std::vector<SummitsInPassing> summits(joints);
  for (std::size_t k = 0; k < taken_.times.size(); ++k) {
    const double t = taken_.times[k];
    if (!is_as_taken) first.world_poses(t, places);
    const std::span<const Eigen::Affine3d> here = is_as_taken ? remembered(k) : places;
    for (std::size_t i = 0; i < joints; ++i) {
      if (!is_apart[i]) {
        others[i] = here[i];
        continue;
      }
      others[i] = second.placed(i, second.local_pose(i, t), others);
      summits[i].pass({t, shell_distance(here[i], others[i], shell_)});
    }
  }
  double known = 0.0;
  for (std::size_t i = 0; i < joints; ++i)
    if (is_apart[i]) known = std::max(known, summits[i].highest_passed().value);
  ClipReduction::Worst worst;
  for (std::size_t i = 0; i < joints; ++i) {
    LargestInTime largest{.time = taken_.times.front()};
    if (is_apart[i]) {
      const Height top = summits[i].highest(
          [&](double t) { return shell_distance(first.world_pose(i, t), second.world_pose(i, t), shell_); }, known);
      known = std::max(known, top.value);
      largest = {top.value, top.place};
    }
    worst.take(largest, i);
  }
  return worst;
}

}}  // namespace orispline
