// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/clip_in_page.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <orispline/math/degrees.hpp>
#include <orispline/pages/curve_page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

constexpr double longest_step = 1.01 / 30.0;  ///< [s] between positions, which are joined by straight lines
constexpr std::size_t keys_of_motion = 3;     ///< a track of rotations with fewer holds a joint or turns it once

using Differences = std::vector<JointDifference>;  // of every joint

void take(report::PageLargest& largest, double value, double time) {
  if (value > largest.value) largest = {value, time};
}

/// Times that are shown as one, by their places.
struct Neighbours {
  std::size_t first = 0, end = 0;
  bool is_key_first = false;  ///< which is then shown, else that where the distance is the largest
};

/// All times in at most so many groups: both ends alone, all else in equal parts.
std::vector<Neighbours> neighbours_in(std::size_t times, std::size_t most) {
  std::vector<Neighbours> groups;
  if (times <= most) {
    for (std::size_t i = 0; i < times; ++i) groups.push_back({i, i + 1});
    return groups;
  }
  const std::size_t parts = most - 2, inner = times - 2;
  groups.push_back({0, 1});
  for (std::size_t i = 0; i < parts; ++i) groups.push_back({1 + i * inner / parts, 1 + (i + 1) * inner / parts});
  groups.push_back({times - 1, times});
  return groups;
}

/// Each key with the times up to the next, or all times by `most`.
std::vector<Neighbours> neighbours_of(const ClipComparison& comparison) {
  const auto& [counterparts, times, shell, most, keys] = comparison;
  if (keys.empty() || keys.size() > most) return neighbours_in(times.size(), most);
  std::vector<Neighbours> groups;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_key = groups.size() < keys.size() && times[i] == keys[groups.size()];
    if (is_key || groups.empty()) groups.push_back({i, i, true});
    groups.back().end = i + 1;
  }
  return groups;
}

double shell_distance_of(const Differences& joints) {
  double largest = 0.0;
  for (const JointDifference& joint : joints) largest = std::max(largest, joint.distance.value);
  return largest;
}

/// The errors at all times, with those of neighbours joined into one.
class ErrorLines {
 public:
  ErrorLines(report::PageClip& clip, const ClipComparison& comparison) : clip_(clip), comparison_(comparison) {
    clip_.joints.resize(comparison.counterparts.size());
    for (report::PageJointErrors& joint : clip_.joints)
      joint.angle.time = joint.distance.time = comparison.times.front();
  }

  void add(const Neighbours& neighbours, const ClipMotion& before, const ClipMotion& after) {
    double shown = comparison_.times[neighbours.first], farthest = -1.0;
    for (report::PageJointErrors& joint : clip_.joints) {
      joint.angles.push_back(0.0);
      joint.distances.push_back(0.0);
    }
    for (std::size_t i = neighbours.first; i < neighbours.end; ++i) {
      const Differences found =
          differences(before, after, comparison_.counterparts, comparison_.times.subspan(i, 1), comparison_.shell);
      take_all(found, neighbours.is_key_first ? shown : comparison_.times[i]);
      if (const double distance = shell_distance_of(found); distance > farthest && !neighbours.is_key_first)
        farthest = distance, shown = comparison_.times[i];
    }
    clip_.error_times.push_back(shown);
  }

 private:
  void take_all(const Differences& found, double time) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      report::PageJointErrors& joint = clip_.joints[i];
      const double angle = found[i].angle.value * degrees, distance = found[i].distance.value;
      take(joint.angle, angle, time);
      take(joint.distance, distance, time);
      joint.angles.back() = std::max(joint.angles.back(), angle);
      joint.distances.back() = std::max(joint.distances.back(), distance);
    }
  }

  report::PageClip& clip_;
  const ClipComparison& comparison_;
};

/// These times, and others between where they are far apart, `most` together or little more.
std::vector<double> dense_times(const std::vector<double>& times, std::size_t most) {
  const double span = times.back() - times.front();
  const double room = most > times.size() ? static_cast<double>(most - times.size()) : 0.5;
  const double step = std::max(longest_step, span / room);
  std::vector<double> dense{times.front()};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double gap = times[i] - times[i - 1];
    const double parts = std::max(std::ceil(gap / step), 1.0);
    for (double k = 1.0; k < parts; ++k) dense.push_back(times[i - 1] + gap * (k / parts));
    dense.push_back(times[i]);
  }
  return dense;
}

void add_positions(report::PageClip& clip, const ClipMotion& before, const ClipMotion& after,
                   std::span<const std::size_t> counterparts) {
  std::vector<Eigen::Affine3d> poses(before.skeleton().size()), others(after.skeleton().size());
  for (const double t : clip.times) {
    before.world_poses(t, poses);
    after.world_poses(t, others);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      clip.before.emplace_back(poses[i].translation());
      clip.after.emplace_back((counterparts[i] == no_parent ? poses[i] : others[counterparts[i]]).translation());
    }
  }
}

std::vector<double> shown_times(const RotationChannel& channel) {
  std::vector<double> times;
  for (const std::size_t key : evenly_picked(channel.size())) times.push_back(channel.times[key]);
  return times;
}

void count_keys(report::PageClip& page, const Clip& before, const Clip& after,
                std::span<const std::size_t> counterparts) {
  for (std::size_t i = 0; i < counterparts.size(); ++i) {
    report::PageJointErrors& joint = page.joints[i];
    if (const auto* channel = channel_of(before.rotations, i)) joint.keys.before = channel->size();
    if (const auto* channel = channel_of(after.rotations, counterparts[i])) {
      joint.keys.after = channel->size();
      joint.key_times = shown_times(*channel);
    }
    if (std::max(joint.keys.before, joint.keys.after) < keys_of_motion) continue;
    page.rotation_keys.before += joint.keys.before;
    page.rotation_keys.after += joint.keys.after;
  }
  for (const VectorChannel& channel : before.translations) page.translation_keys.before += channel.size();
  for (const VectorChannel& channel : after.translations) page.translation_keys.after += channel.size();
}

template <CurvePoint P>
std::vector<Channel<P>> held(const std::vector<Channel<P>>& channels) {
  std::vector<Channel<P>> still;
  for (const Channel<P>& channel : channels)
    still.push_back({.joint = channel.joint, .times = {channel.times.front()}, .values = {channel.values.front()}});
  return still;
}

ClipMotion motion_of(const ClipOf& shown) {
  return shown.motion ? *shown.motion : ClipMotion(shown.skeleton, shown.clip);
}

/// Where the clip begins, all the time.
Clip held_at_start(const Clip& clip) {
  return {.name = clip.name,
          .rotations = held(clip.rotations),
          .translations = held(clip.translations),
          .scales = held(clip.scales)};
}

}  // namespace

report::PageClip clip_in_page(const ClipOf& before, const ClipOf& after, const ClipComparison& comparison) {
  report::PageClip page{.name = before.clip.name, .start = comparison.times.front(), .end = comparison.times.back()};
  const ClipMotion first = motion_of(before), second = motion_of(after);
  ErrorLines lines(page, comparison);
  for (const Neighbours& neighbours : neighbours_of(comparison)) lines.add(neighbours, first, second);
  page.times = dense_times(page.error_times, comparison.most);
  add_positions(page, first, second, comparison.counterparts);
  count_keys(page, before.clip, after.clip, comparison.counterparts);
  return page;
}

report::PageClip clip_alone_in_page(const ClipOf& shown, const ClipComparison& comparison) {
  const Clip start = held_at_start(shown.clip);
  report::PageClip page = clip_in_page(shown, {shown.skeleton, start}, comparison);
  page.after.clear();
  page.rotation_keys.after = page.translation_keys.after = 0;
  for (report::PageJointErrors& joint : page.joints) joint.keys.after = 0;
  for (const RotationChannel& channel : shown.clip.rotations)
    page.joints[channel.joint].key_times = shown_times(channel);
  return page;
}

}}}  // namespace orispline::pages
