// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/version.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/clip_in_page.hpp>
#include <orispline/pages/curve_page.hpp>
#include <orispline/reduce/channel_reduction.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/reduce/taken_clip.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

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

/// Those of a skeleton, each its own counterpart.
std::vector<std::size_t> own_joints(const Skeleton& skeleton) {
  std::vector<std::size_t> joints(skeleton.size());
  std::iota(joints.begin(), joints.end(), std::size_t{0});
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

double farthest_of(const report::SkeletonPage& page) {
  double largest = 0.0;
  for (const report::PageClip& clip : page.clips) largest = std::max(largest, largest_distance(clip));
  return largest;
}

/// Lengths in metres, or where all that differs is less than one in millimetres.
void scale(report::SkeletonPage& page, const PageLengths& lengths) {
  double factor = 1.0;
  if (lengths.are_known) {
    const bool is_small = farthest_of(page) < 1.0;
    page.length_unit = is_small ? "mm" : "m";
    if (is_small) factor /= millimetre;
  }
  page.shell *= factor;
  if (page.distance_limit) *page.distance_limit *= factor;
  for (report::PageClip& clip : page.clips) scale(clip, factor);
}

std::size_t most_times(std::span<const ClipPair> pairs) {
  return pairs.size() > few_clips ? times_of_many : times_of_few;
}

void add_notes(report::SkeletonPage& page, std::span<const ClipPair> pairs) {
  const std::size_t most = most_times(pairs);
  const bool is_alone = page.after.empty();
  const auto is_long = [&](const ClipPair& pair) { return pair.times.size() > most; };
  if (std::ranges::any_of(pairs, is_long))
    page.notes.push_back(
        formatted("Of clips with more than {} times {} are shown, with the largest {} of every few, so "
                  "that none is lost.",
                  most, most, is_alone ? "distances and angles" : "errors"));
  const auto is_thinned = [&](const report::PageClip& clip) {
    return std::ranges::any_of(clip.joints, [&](const report::PageJointErrors& joint) {
      return joint.key_times.size() == samples_of_few &&
             (is_alone ? joint.keys.before : joint.keys.after) > samples_of_few;
    });
  };
  if (std::ranges::any_of(page.clips, is_thinned))
    page.notes.push_back(
        formatted("Of rotations with more than {} keys {} are marked, evenly picked.", samples_of_few, samples_of_few));
  if (const auto alone = std::ranges::count(page.joints, false, &report::PageJoint::is_compared); alone > 0)
    page.notes.push_back(formatted("Only {} has {} that {} shown in grey and not compared.", page.before,
                                   counted(static_cast<std::size_t>(alone), "joint"), alone == 1 ? "is" : "are"));
}

report::SkeletonPage begun_skeleton_page(const std::string& title, std::string_view before, std::string_view after,
                                         const PageLengths& lengths, const PageHead& head) {
  return {.title = head.title.empty() ? title : head.title,
          .command = head.command,
          .date = head.date,
          .version = std::string(version),
          .notes = head.notes,
          .before = std::string(file_name_of(before)),
          .after = std::string(file_name_of(after)),
          .shell = lengths.shell};
}

/// A clip as the page shows it.
using ClipMaker = std::function<report::PageClip(const ClipPair&, const ClipComparison&)>;

/// In the unit of the file, in the order of the pairs.
void add_clips(report::SkeletonPage& page, const Skeleton& skeleton, std::span<const std::size_t> counterparts,
               std::span<const ClipPair> pairs, unsigned threads, const ClipMaker& made) {
  page.joints = joints_of(skeleton, counterparts);
  page.clips.resize(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    page.clips[i] = made(pairs[i], {counterparts, pairs[i].times, page.shell, most_times(pairs)});
  });
}

/// In the unit of the file, in the order of the pairs.
report::SkeletonPage unfinished_page(const NamedClips& before, const NamedClips& after, std::span<const ClipPair> pairs,
                                     const PageLengths& lengths, const PageHead& head, unsigned threads) {
  const std::string title = formatted("{} and {}", file_name_of(before.name), file_name_of(after.name));
  report::SkeletonPage page = begun_skeleton_page(title, before.name, after.name, lengths, head);
  add_clips(page, before.skeleton, counterparts_of(before.skeleton, after.skeleton).joints, pairs, threads,
            [&](const ClipPair& pair, const ClipComparison& comparison) {
              return clip_in_page({before.skeleton, before.clips[pair.before]},
                                  {after.skeleton, after.clips[pair.after]}, comparison);
            });
  return page;
}

/// The clips that are farthest off first, with the notes, in the unit of the page.
report::SkeletonPage finished(report::SkeletonPage page, std::span<const ClipPair> pairs, const PageLengths& lengths) {
  add_notes(page, pairs);
  std::ranges::stable_sort(page.clips, std::ranges::greater(), largest_distance);
  scale(page, lengths);
  return page;
}

/// Each clip beside the one in its place, at its keys.
std::vector<ClipPair> pairs_at_keys(std::span<const Clip> clips) {
  std::vector<ClipPair> pairs;
  for (const Clip& clip : clips) {
    std::vector<double> times = key_times(clip);
    if (times.empty()) times.push_back(0.0);
    pairs.push_back({pairs.size(), pairs.size(), std::move(times)});
  }
  return pairs;
}

constexpr std::string_view compared_at_keys = "Both motions are compared at every key of the input.";

/// The times at which a reduction was looked at, and those at which it is farthest off.
std::vector<double> times_of(const TakenClip& taken, const ClipReduction& reduction) {
  std::vector<double> times = taken.times;
  if (times.empty()) times.push_back(0.0);
  for (const ClipReduction::Worst* worst : {&reduction.angle, &reduction.translation, &reduction.distance})
    if (worst->is_known()) times.push_back(worst->largest.time);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::string compared_between_keys(BetweenSamples between) {
  return formatted(
      "Both motions are compared at every key of the input, in {} places between two of them, and where they are "
      "farthest apart; a key shows the largest error up to the next. Between its keys the input is {}.",
      looks_between, between == BetweenSamples::smooth ? "the curve auto through them" : "what its file says");
}

/// `8377 of 55868 keys of rotations`
std::string keys_text(std::span<const ClipReduction> reductions) {
  const ClipTotals totals = totals_of(reductions);
  return formatted("{} of {} of rotations", totals.rotation_keys, counted(totals.rotation_keys_before, "key"));
}

/// What was found of all rotations that were smoothed.
struct SmoothedRotations {
  std::size_t count = 0, left = 0, rejected = 0;
  double shortest = 0.0, longest = 0.0;  ///< smoothing times [s]
};

SmoothedRotations found_in(std::span<const ClipSmoothing> smoothings) {
  SmoothedRotations found;
  for (const ClipSmoothing& smoothing : smoothings) {
    found.left += smoothing.left;
    for (const ClipSmoothing::OfJoint& joint : smoothing.joints) {
      const double time = joint.smoothing.smoothing_time;
      found.shortest = found.count == 0 ? time : std::min(found.shortest, time);
      found.longest = std::max(found.longest, time);
      found.rejected += joint.smoothing.rejected.size();
      ++found.count;
    }
  }
  return found;
}

/// `walk.bvh smoothed: 31 rotations of 1 clip, 5 samples rejected`
std::string smoothed_title(std::string_view name, std::span<const ClipSmoothing> smoothings) {
  const SmoothedRotations found = found_in(smoothings);
  return formatted("{} smoothed: {} of {}, {} rejected", name, counted(found.count, "rotation"),
                   counted(smoothings.size(), "clip"), counted(found.rejected, "sample"));
}

/// `Frames 100 to 111, 1.667 s to 1.85 s, of Arm and Hand are bridged: they jump by up to 60.5°.`
std::string note_on(const Skeleton& skeleton, const WrongRun& run) {
  std::vector<std::string> names;
  for (const std::size_t joint : run.joints) names.push_back(printable(skeleton.shown_name(joint)));
  return formatted("Frames {} to {}, {:.4g} s to {:.4g} s, of {} are bridged: {} by up to {:.3g}°.", run.first,
                   run.first + run.count - 1, run.start, run.end, joined(names, ", "),
                   names.size() == 1 ? "it jumps" : "they jump", run.jump * degrees);
}

/// `LeftFoot is held on frames 20 to 45, 0.667 s to 1.5 s.`
std::string note_on(const Skeleton& skeleton, const Contact& contact) {
  return formatted("{} is held on frames {} to {}, {:.4g} s to {:.4g} s.",
                   printable(skeleton.shown_name(contact.joint)), contact.first, contact.first + contact.count - 1,
                   contact.start, contact.end);
}

/// What was found of one kind in all clips, of much the first ones.
template <class Found>
void add_notes_on(std::vector<std::string>& notes, const Skeleton& skeleton, std::span<const ClipSmoothing> smoothings,
                  std::vector<Found> ClipSmoothing::*found, std::string_view kind) {
  constexpr std::size_t most = 40;
  std::size_t count = 0;
  for (const ClipSmoothing& smoothing : smoothings)
    for (const Found& one : smoothing.*found)
      if (count++ < most)
        notes.push_back((smoothings.size() > 1 ? formatted("Clip {}: ", in_quotes(smoothing.clip.name)) : "") +
                        note_on(skeleton, one));
  if (count > most) notes.push_back(formatted("There are {} more.", counted(count - most, kind)));
}

std::vector<std::string> notes_on(const Skeleton& skeleton, std::span<const ClipSmoothing> smoothings) {
  const SmoothedRotations found = found_in(smoothings);
  std::vector<std::string> notes;
  if (found.count > 0)
    notes.push_back(found.shortest == found.longest
                        ? formatted("The smoothing time is {:.4g} s.", found.shortest)
                        : formatted("Smoothing times go from {:.4g} s to {:.4g} s.", found.shortest, found.longest));
  if (found.rejected > 0)
    notes.push_back(formatted("{} and marked.",
                              counted(found.rejected, "sample") +
                                  (found.rejected == 1 ? " is rejected as an outlier" : " are rejected as outliers")));
  if (found.left > 0)
    notes.push_back(formatted(
        "Rotations that rest, are steps or splines, or have too few keys are left as they are: {}.", found.left));
  add_notes_on(notes, skeleton, smoothings, &ClipSmoothing::runs, "run");
  add_notes_on(notes, skeleton, smoothings, &ClipSmoothing::contacts, "contact");
  notes.emplace_back(compared_at_keys);
  return notes;
}

/// In the place of the keys, which are as many as before, those that were rejected.
void mark_rejected(report::PageClip& page, const Clip& before, const ClipSmoothing& smoothing) {
  for (report::PageJointErrors& joint : page.joints) joint.key_times.clear();
  for (const ClipSmoothing::OfJoint& found : smoothing.joints) {
    const auto& times = channel_of(before.rotations, found.joint)->times;
    const std::vector<std::size_t>& rejected = found.smoothing.rejected;
    for (const std::size_t place : evenly_picked(rejected.size()))
      page.joints[found.joint].key_times.push_back(times[rejected[place]]);
  }
}

}  // namespace

report::SkeletonPage skeleton_page(const NamedClips& before, const NamedClips& after, std::span<const ClipPair> pairs,
                                   const PageLengths& lengths, const PageHead& head, unsigned threads) {
  return finished(unfinished_page(before, after, pairs, lengths, head, threads), pairs, lengths);
}

report::SkeletonPage scene_page(const NamedClips& scene, const PageLengths& lengths, const PageHead& head,
                                unsigned threads) {
  const std::vector<Clip> resting{{.name = "rest pose"}};
  const std::span<const Clip> clips = scene.clips.empty() ? resting : scene.clips;
  const std::vector<ClipPair> pairs = pairs_at_keys(clips);
  const std::string title = formatted("{}: {}, {}", file_name_of(scene.name), counted(scene.skeleton.size(), "joint"),
                                      counted(scene.clips.size(), "clip"));
  report::SkeletonPage page = begun_skeleton_page(title, scene.name, "", lengths, head);
  if (scene.skeleton.size() == 0) page.notes.emplace_back("There is no joint to show.");
  else if (scene.clips.empty()) page.notes.emplace_back("No clip moves the skeleton: it is shown in its rest pose.");
  add_clips(page, scene.skeleton, own_joints(scene.skeleton), pairs, threads,
            [&](const ClipPair& pair, const ClipComparison& comparison) {
              return clip_alone_in_page({scene.skeleton, clips[pair.before]}, comparison);
            });
  add_notes(page, pairs);
  scale(page, lengths);
  return page;
}

report::SkeletonPage smoothed_clips_page(const NamedClips& before, std::string after,
                                         std::span<const ClipSmoothing> smoothings, const PageLengths& lengths,
                                         const PageHead& head, unsigned threads) {
  std::vector<Clip> clips;
  for (const ClipSmoothing& smoothing : smoothings) clips.push_back(smoothing.clip);
  const std::vector<ClipPair> pairs = pairs_at_keys(before.clips);
  report::SkeletonPage page =
      unfinished_page(before, {std::move(after), before.skeleton, clips}, pairs, lengths, head, threads);
  if (head.title.empty()) page.title = smoothed_title(page.before, smoothings);
  std::ranges::move(notes_on(before.skeleton, smoothings), std::back_inserter(page.notes));
  for (std::size_t i = 0; i < smoothings.size(); ++i) mark_rejected(page.clips[i], before.clips[i], smoothings[i]);
  return finished(std::move(page), pairs, lengths);
}

report::SkeletonPage reduced_clips_page(const NamedClips& before, std::string after,
                                        std::span<const ClipReduction> reductions, const ClipReduceOptions& options,
                                        const PageLengths& lengths, const PageHead& head, unsigned threads) {
  const std::vector<ClipPair> at_keys = pairs_at_keys(before.clips);
  std::vector<TakenClip> taken;
  std::vector<ClipPair> pairs;
  for (std::size_t i = 0; i < reductions.size(); ++i) {
    taken.emplace_back(before.skeleton, before.clips[i], options);
    pairs.push_back({i, i, times_of(taken.back(), reductions[i])});
  }
  report::SkeletonPage page = begun_skeleton_page("", before.name, after, lengths, head);
  add_clips(page, before.skeleton, own_joints(before.skeleton), pairs, threads,
            [&](const ClipPair& pair, ClipComparison comparison) {
              comparison.keys = at_keys[pair.before].times;
              const Clip fewer = as_stored(reductions[pair.after].clip, options);
              const ClipMotion motion = taken[pair.before].beside(before.skeleton, fewer);
              return clip_in_page({before.skeleton, before.clips[pair.before], &motion}, {before.skeleton, fewer},
                                  comparison);
            });
  if (head.title.empty())
    page.title = formatted("{} within {}: {}", page.before, tolerance_text(options, lengths.are_known ? " m" : ""),
                           keys_text(reductions));
  page.notes.insert(page.notes.begin(), compared_between_keys(options.between));
  if (std::isfinite(options.tolerance)) page.angle_limit = options.tolerance * degrees;
  if (std::isfinite(options.world_tolerance)) page.distance_limit = options.world_tolerance;
  return finished(std::move(page), at_keys, lengths);
}

}}}  // namespace orispline::pages
