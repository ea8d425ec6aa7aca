// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/version.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

/// A clip of a skeleton.
struct ClipOf {
  const Skeleton& skeleton;
  const Clip& clip;
};

/// How two motions of a clip are compared.
struct ClipComparison {
  std::span<const std::size_t> counterparts;  ///< of the joints before: the same ones after, or `no_parent`
  std::span<const double> times;              ///< [s], increasing, one at least
  double shell = default_shell;
  std::size_t most = 600;  ///< times that are shown, at least 3
};

constexpr double longest_step = 1.01 / 30.0;  ///< [s] between positions, which are joined by straight lines
constexpr std::size_t keys_of_motion = 3;     ///< a track of rotations with fewer holds a joint or turns it once

using Differences = std::vector<JointDifference>;  // of every joint

void take(report::PageLargest& largest, double value, double time) {
  if (value > largest.value) largest = {value, time};
}

/// Times that are shown as one, by their places.
struct Neighbours {
  std::size_t first = 0, end = 0;
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
      take_all(found, comparison_.times[i]);
      if (const double distance = shell_distance_of(found); distance > farthest)
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

void count_keys(report::PageClip& page, const Clip& before, const Clip& after,
                std::span<const std::size_t> counterparts) {
  for (std::size_t i = 0; i < counterparts.size(); ++i) {
    report::PageJointErrors& joint = page.joints[i];
    if (const auto* channel = channel_of(before.rotations, i)) joint.keys.before = channel->size();
    if (const auto* channel = channel_of(after.rotations, counterparts[i])) {
      joint.keys.after = channel->size();
      joint.key_times = channel->times;
    }
    if (std::max(joint.keys.before, joint.keys.after) < keys_of_motion) continue;
    page.rotation_keys.before += joint.keys.before;
    page.rotation_keys.after += joint.keys.after;
  }
  for (const VectorChannel& channel : before.translations) page.translation_keys.before += channel.size();
  for (const VectorChannel& channel : after.translations) page.translation_keys.after += channel.size();
}

/// The clip in both motions as a page shows it, lengths in the unit of the skeletons. Of more than `most` times those
/// are shown where the shell distance is the largest of so many neighbours; the angles and distances there are the
/// largest of these neighbours too. Where times are far apart there are positions between them.
report::PageClip clip_in_page(const ClipOf& before, const ClipOf& after, const ClipComparison& comparison) {
  report::PageClip page{.name = before.clip.name, .start = comparison.times.front(), .end = comparison.times.back()};
  const ClipMotion first(before.skeleton, before.clip), second(after.skeleton, after.clip);
  ErrorLines lines(page, comparison);
  for (const Neighbours& neighbours : neighbours_in(comparison.times.size(), comparison.most))
    lines.add(neighbours, first, second);
  page.times = dense_times(page.error_times, comparison.most);
  add_positions(page, first, second, comparison.counterparts);
  count_keys(page, before.clip, after.clip, comparison.counterparts);
  return page;
}

constexpr std::size_t few_clips = 10, times_of_few = 600, times_of_many = 300;
constexpr double millimetre = 1e-3;  ///< [m]

std::vector<report::PageJoint> joints_of(const Skeleton& skeleton, std::span<const std::size_t> counterparts) {
  std::vector<report::PageJoint> joints;
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    report::PageJoint joint{.name = skeleton[i].name, .is_compared = counterparts[i] != no_parent};
    if (skeleton[i].parent != no_parent) joint.parent = skeleton[i].parent;
    joints.push_back(std::move(joint));
  }
  return joints;
}

double largest_distance(const report::PageClip& clip) {
  double largest = 0.0;
  for (const report::PageJointErrors& joint : clip.joints) largest = std::max(largest, joint.distance.value);
  return largest;
}

void scale(report::PageClip& clip, double factor) {
  for (std::vector<Eigen::Vector3d>* const places : {&clip.before, &clip.after})
    for (Eigen::Vector3d& place : *places) place *= factor;
  for (report::PageJointErrors& joint : clip.joints) {
    joint.distance.value *= factor;
    for (double& distance : joint.distances) distance *= factor;
  }
}

/// Lengths in metres, or where all that differs is less than one in millimetres.
void scale(report::SkeletonPage& page, const PageLengths& lengths) {
  double factor = lengths.metres;
  if (lengths.are_known) {
    const bool is_small = page.clips.empty() || largest_distance(page.clips.front()) * lengths.metres < 1.0;
    page.length_unit = is_small ? "mm" : "m";
    if (is_small) factor /= millimetre;
  }
  page.shell *= factor;
  if (page.distance_limit) *page.distance_limit *= factor;
  for (report::PageClip& clip : page.clips) scale(clip, factor);
}

std::string title_of(std::string_view before, std::string_view after) {
  return formatted("{} and {}", file_name_of(before), file_name_of(after));
}

void add_notes(report::SkeletonPage& page, std::span<const ClipPair> pairs, std::size_t most) {
  const auto is_long = [&](const ClipPair& pair) { return pair.times.size() > most; };
  if (std::ranges::any_of(pairs, is_long))
    page.notes.push_back(formatted(
        "Of clips with more than {} times {} are shown, with the largest errors of every few, so that none is lost.",
        most, most));
  if (const auto alone = std::ranges::count(page.joints, false, &report::PageJoint::is_compared); alone > 0)
    page.notes.push_back(formatted("Only {} has {} that {} shown in grey and not compared.", page.before,
                                   counted(static_cast<std::size_t>(alone), "joint"), alone == 1 ? "is" : "are"));
}

report::SkeletonPage begun_skeleton_page(const NamedClips& before, const NamedClips& after, const PageLengths& lengths,
                                         const PageHead& head) {
  return {.title = head.title.empty() ? title_of(before.name, after.name) : head.title,
          .command = head.command,
          .date = head.date,
          .version = std::string(version),
          .notes = head.notes,
          .before = std::string(file_name_of(before.name)),
          .after = std::string(file_name_of(after.name)),
          .shell = lengths.shell};
}

/// In the unit of the file.
report::SkeletonPage unscaled_page(const NamedClips& before, const NamedClips& after, std::span<const ClipPair> pairs,
                                   const PageLengths& lengths, const PageHead& head, unsigned threads) {
  report::SkeletonPage page = begun_skeleton_page(before, after, lengths, head);
  const std::vector<std::size_t> counterparts = counterparts_of(before.skeleton, after.skeleton).joints;
  page.joints = joints_of(before.skeleton, counterparts);
  const std::size_t most = pairs.size() > few_clips ? times_of_many : times_of_few;
  add_notes(page, pairs, most);
  page.clips.resize(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    page.clips[i] =
        clip_in_page({before.skeleton, before.clips[pairs[i].before]}, {after.skeleton, after.clips[pairs[i].after]},
                     {counterparts, pairs[i].times, lengths.shell, most});
  });
  std::ranges::stable_sort(page.clips, std::ranges::greater(), largest_distance);
  return page;
}

/// `8377 of 55868 keys of rotations`
std::string keys_text(std::span<const ClipReduction> reductions) {
  const ClipTotals totals = totals_of(reductions);
  return formatted("{} of {} of rotations", totals.rotation_keys, counted(totals.rotation_keys_before, "key"));
}

}  // namespace

report::SkeletonPage skeleton_page(const NamedClips& before, const NamedClips& after, std::span<const ClipPair> pairs,
                                   const PageLengths& lengths, const PageHead& head, unsigned threads) {
  report::SkeletonPage page = unscaled_page(before, after, pairs, lengths, head, threads);
  scale(page, lengths);
  return page;
}

report::SkeletonPage reduced_clips_page(const NamedClips& before, std::string after,
                                        std::span<const ClipReduction> reductions, const ClipReduceOptions& options,
                                        const PageLengths& lengths, const PageHead& head, unsigned threads) {
  std::vector<Clip> clips;
  std::vector<ClipPair> pairs;
  for (std::size_t i = 0; i < reductions.size(); ++i) {
    clips.push_back(as_stored(reductions[i].clip, options));
    std::vector<double> times = key_times(before.clips[i]);
    if (times.empty()) times.push_back(0.0);
    pairs.push_back({i, i, std::move(times)});
  }
  report::SkeletonPage page =
      unscaled_page(before, {std::move(after), before.skeleton, clips}, pairs, lengths, head, threads);
  if (head.title.empty())
    page.title =
        formatted("{} within {}: {}", page.before,
                  tolerance_text(options, lengths.metres, lengths.are_known ? " m" : ""), keys_text(reductions));
  page.notes.insert(page.notes.begin(), "Both motions are compared at every key of the input.");
  if (std::isfinite(options.tolerance)) page.angle_limit = options.tolerance * degrees;
  if (std::isfinite(options.world_tolerance)) page.distance_limit = options.world_tolerance;
  scale(page, lengths);
  return page;
}

}}}  // namespace orispline::pages
