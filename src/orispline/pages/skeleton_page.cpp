// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/skeleton_page.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/version.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/clip_in_page.hpp>
#include <orispline/reduce/reduce_fields.hpp>

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
  const auto counterparts = counterparts_of(before.skeleton, after.skeleton);
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
  std::size_t after = 0, before = 0;
  for (const ClipReduction& reduction : reductions) {
    after += reduction.rotation_keys;
    before += reduction.rotation_keys_before;
  }
  return formatted("{} of {} of rotations", after, counted(before, "key"));
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
