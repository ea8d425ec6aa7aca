// SPDX-License-Identifier: Apache-2.0
// Pages of skeletons from plain clips: a bone of length 1 that turns about z, and a tip at its end.
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/base/version.hpp>
#include <orispline/math/degrees.hpp>
#include <pages/page_head.hpp>

namespace orispline { namespace {

Skeleton bone(std::string tip = "tip") {
  return Skeleton::make(
             {{.name = "root"},
              {.name = std::move(tip), .parent = 0, .rest = {.translation = Eigen::Vector3d(1.0, 0.0, 0.0)}}})
      .value();
}

Eigen::Quaterniond about_z(double angle) { return {std::cos(angle / 2.0), 0.0, 0.0, std::sin(angle / 2.0)}; }

/// Keys every 10 ms; the angle at each by its index.
template <class AngleOf>
Clip turning(std::size_t keys, AngleOf angle_of) {
  Clip clip{.name = "turn", .rotations = {{.joint = 0}}};
  for (std::size_t i = 0; i < keys; ++i) {
    clip.rotations[0].times.push_back(0.01 * static_cast<double>(i));
    clip.rotations[0].values.push_back(about_z(angle_of(i)));
  }
  return clip;
}

Clip slow(std::size_t keys) {
  return turning(keys, [](std::size_t i) { return 1e-3 * static_cast<double>(i); });
}

/// Like `slow`, but off by an angle at one key.
Clip off_at(std::size_t keys, std::size_t key, double angle) {
  return turning(keys, [&](std::size_t i) { return 1e-3 * static_cast<double>(i) + (i == key ? angle : 0.0); });
}

report::SkeletonPage page_of(const Clip& before, const Clip& after, const pages::PageLengths& lengths = {}) {
  const Skeleton skeleton = bone();
  const pages::ClipPair pair{.times = key_times(before)};
  return pages::skeleton_page({"folder/a.glb", skeleton, {&before, 1}}, {"b.glb", skeleton, {&after, 1}}, {&pair, 1},
                              lengths, head);
}

TEST(SkeletonPage, HasWhereTheJointsAreAndHowFarTheyAreOff) {
  const report::SkeletonPage page = page_of(slow(101), off_at(101, 40, 0.01), {.shell = 0.5});
  EXPECT_EQ(page.title, "a.glb and b.glb");
  EXPECT_EQ(page.command, head.command);
  EXPECT_EQ(page.version, version);
  EXPECT_EQ(page.notes, head.notes);
  EXPECT_EQ(page.length_unit, "mm");
  EXPECT_DOUBLE_EQ(page.shell, 500.0);
  ASSERT_EQ(page.joints.size(), 2U);
  EXPECT_EQ(page.joints[1].parent, 0U);
  const report::PageClip& clip = page.clips.at(0);
  EXPECT_EQ(clip.error_times.size(), 101U);
  EXPECT_EQ(clip.rotation_keys.before, 101U);
  EXPECT_NEAR(clip.joints[0].angles[40], 0.01 * degrees, 1e-9);
  EXPECT_DOUBLE_EQ(clip.joints[0].angle.time, 0.4);
  EXPECT_EQ(clip.joints[0].key_times.size(), 101U);
  // The tip is 1 from the root; its shell's farthest point along the bone is 1.5 from it.
  EXPECT_NEAR(clip.joints[1].distance.value, 1000.0 * 1.5 * 2.0 * std::sin(0.005), 1e-9);
  EXPECT_NEAR(clip.joints[1].distances[39], 0.0, 1e-9);
  const std::size_t tip = 2 * 40 + 1;
  EXPECT_EQ(clip.times, clip.error_times);
  EXPECT_NEAR(clip.before[tip].y(), 1000.0 * std::sin(0.04), 1e-9);
  EXPECT_NEAR(clip.after[tip].y(), 1000.0 * std::sin(0.05), 1e-9);
}

TEST(SkeletonPage, LosesNoErrorOfALongClip) {
  for (const std::size_t key : {1UL, 1234UL, 2749UL}) {
    const report::SkeletonPage page = page_of(slow(2751), off_at(2751, key, 0.01));
    const report::PageClip& clip = page.clips.at(0);
    EXPECT_EQ(clip.error_times.size(), 600U);
    EXPECT_TRUE(std::ranges::is_sorted(clip.error_times));
    EXPECT_DOUBLE_EQ(clip.error_times.front(), 0.0);
    EXPECT_DOUBLE_EQ(clip.error_times.back(), 27.5);
    EXPECT_NEAR(std::ranges::max(clip.joints[0].angles), 0.01 * degrees, 1e-9);
    EXPECT_EQ(std::ranges::count(clip.error_times, 0.01 * static_cast<double>(key)), 1);
    EXPECT_EQ(page.notes.size(), 3U);
    EXPECT_EQ(page.notes.back(), "Of rotations with more than 2000 keys 2000 are marked, evenly picked.");
    EXPECT_EQ(clip.joints[0].key_times.size(), 2000U);
    EXPECT_DOUBLE_EQ(clip.joints[0].key_times.back(), 27.5);
  }
}

TEST(SkeletonPage, HasPositionsBetweenKeysThatAreFarApart) {
  Clip clip = slow(3);
  clip.rotations[0].times = {0.0, 0.02, 1.0};
  const report::SkeletonPage page = page_of(clip, clip);
  EXPECT_EQ(page.clips[0].error_times, clip.rotations[0].times);
  EXPECT_GE(page.clips[0].times.size(), 30U);
  EXPECT_TRUE(std::ranges::is_sorted(page.clips[0].times));
  EXPECT_EQ(page.clips[0].before.size(), 2 * page.clips[0].times.size());
}

TEST(SkeletonPage, LeavesAloneWhatOneFileHasNot) {
  const Clip clip = slow(11);
  const Skeleton first = bone(), second = bone("hand");
  const pages::ClipPair pair{.times = key_times(clip)};
  const report::SkeletonPage page = pages::skeleton_page({"a.bvh", first, {&clip, 1}}, {"b.bvh", second, {&clip, 1}},
                                                         {&pair, 1}, {.are_known = false}, head);
  EXPECT_TRUE(page.joints[0].is_compared);
  EXPECT_FALSE(page.joints[1].is_compared);
  EXPECT_EQ(page.length_unit, "");
  EXPECT_EQ(page.notes.back(), "Only a.bvh has 1 joint that is shown in grey and not compared.");
  EXPECT_EQ(page.clips[0].before, page.clips[0].after);
}

TEST(ScenePage, ShowsTheClipsAloneInTheirOrderWithTheWayFromTheirStart) {
  const Skeleton skeleton = bone();
  Clip wide = off_at(101, 40, 0.5);
  wide.rotations[0].times[0] = -1.0;
  wide.translations = {{.joint = 0, .times = {0.0}, .values = {Eigen::Vector3d(2.0, 0.0, 0.0)}}};
  const std::vector<Clip> clips{slow(11), wide};
  const report::SkeletonPage page = pages::scene_page({"folder/a.glb", skeleton, clips}, {.shell = 0.5}, head);
  EXPECT_EQ(page.title, "a.glb: 2 joints, 2 clips");
  EXPECT_EQ(page.before, "a.glb");
  EXPECT_EQ(page.after, "");
  EXPECT_EQ(page.notes, head.notes);
  EXPECT_EQ(page.length_unit, "mm");
  EXPECT_EQ(page.clips[0].end, 0.1);
  const report::PageClip& clip = page.clips.at(1);
  EXPECT_EQ(clip.start, -1.0);
  EXPECT_TRUE(clip.after.empty());
  EXPECT_EQ(clip.before.size(), 2 * clip.times.size());
  EXPECT_EQ(clip.rotation_keys.before, 101U);
  EXPECT_EQ(clip.translation_keys.before, 1U);
  for (const report::PageKeyCounts& keys : {clip.rotation_keys, clip.translation_keys, clip.joints[0].keys})
    EXPECT_EQ(keys.after, 0U);
  EXPECT_EQ(clip.joints[0].key_times, wide.rotations[0].times);
  EXPECT_EQ(clip.joints[0].angle.time, 0.4);
  EXPECT_NEAR(clip.joints[0].angle.value, 0.54 * degrees, 1e-9);
  EXPECT_NEAR(clip.joints[1].distance.value, 1000.0 * 1.5 * 2.0 * std::sin(0.27), 1e-9);
}

TEST(ScenePage, WithoutAClipShowsTheRestPose) {
  const Skeleton skeleton = bone();
  const report::SkeletonPage page = pages::scene_page({"a.bvh", skeleton, {}}, {.are_known = false}, head);
  EXPECT_EQ(page.title, "a.bvh: 2 joints, 0 clips");
  EXPECT_EQ(page.notes.back(), "No clip moves the skeleton: it is shown in its rest pose.");
  ASSERT_EQ(page.clips.size(), 1U);
  EXPECT_EQ(page.clips[0].name, "rest pose");
  EXPECT_EQ(page.clips[0].before, (std::vector<Eigen::Vector3d>{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}));
}

TEST(SmoothedClipsPage, MarksWhatWasRejectedAndSaysWhatWasFound) {
  const Skeleton skeleton = bone();
  Clip noisy = turning(200, [](std::size_t i) {
    return 0.5 * std::sin(0.05 * static_cast<double>(i)) + (i == 70 ? 0.3 : 1e-3 * (i % 2 ? 1.0 : -1.0));
  });
  noisy.rotations.push_back(turning(5, [](std::size_t i) { return static_cast<double>(i); }).rotations[0]);
  noisy.rotations[1].joint = 1;
  const std::vector<Clip> clips{slow(30), noisy};
  const auto smoothings = smooth_clips(skeleton, clips, {.smoothing_time = 0.02}).value();
  const report::SkeletonPage page =
      pages::smoothed_clips_page({"walk.bvh", skeleton, clips}, "clean.bvh", smoothings, {.are_known = false}, head);
  EXPECT_EQ(page.title, "walk.bvh smoothed: 2 rotations of 2 clips, 1 sample rejected");
  EXPECT_EQ(page.after, "clean.bvh");
  std::vector<std::string> notes = head.notes;
  for (const char* const note :
       {"The smoothing time is 0.02 s.", "1 sample is rejected as an outlier and marked.",
        "Rotations that rest, are steps or splines, or have too few keys are left as they are: 1.",
        "Both motions are compared at every key of the input."})
    notes.emplace_back(note);
  EXPECT_EQ(page.notes, notes);
  const report::PageClip& clip = page.clips.at(0);  // the one that changed more
  EXPECT_EQ(clip.rotation_keys.before, 205U);
  EXPECT_EQ(clip.rotation_keys.after, 205U);
  EXPECT_EQ(clip.joints[0].key_times, (std::vector{noisy.rotations[0].times[70]}));
  EXPECT_TRUE(clip.joints[1].key_times.empty());
  EXPECT_DOUBLE_EQ(clip.joints[0].angle.value, smoothings[1].joints[0].largest_change * degrees);
  EXPECT_DOUBLE_EQ(clip.joints[0].angle.time, 0.7);
}

TEST(ReducedClipsPage, HasTheTolerancesAndTheClipThatIsFarthestOffFirst) {
  const Skeleton skeleton = bone();
  const auto wave = [](double size) {
    return turning(201, [=](std::size_t i) { return size * std::sin(0.05 * static_cast<double>(i)); });
  };
  const std::vector<Clip> clips{wave(1e-7), wave(0.5)};
  const ClipReduceOptions options{.tolerance = 0.5 / degrees, .world_tolerance = 0.02};
  const auto reductions = reduce_clips(skeleton, clips, options).value();
  const report::SkeletonPage page =
      pages::reduced_clips_page({"arm.glb", skeleton, clips}, "small.glb", reductions, options, {}, head);
  const std::size_t kept = reductions[1].rotation_keys + reductions[0].rotation_keys;
  EXPECT_EQ(page.title,
            "arm.glb within 0.5°, 0.02 m in the world: " + std::to_string(kept) + " of 402 keys of rotations");
  EXPECT_DOUBLE_EQ(page.angle_limit.value(), 0.5);
  EXPECT_DOUBLE_EQ(page.distance_limit.value(), 20.0);
  EXPECT_EQ(page.clips[0].rotation_keys.after, reductions[1].rotation_keys);
  EXPECT_EQ(page.clips[0].joints[0].key_times, reductions[1].clip.rotations[0].times);
  EXPECT_DOUBLE_EQ(page.clips[0].joints[0].angle.value, reductions[1].angle.largest.value * degrees);
  EXPECT_DOUBLE_EQ(page.clips[0].joints[reductions[1].distance.joint].distance.value,
                   reductions[1].distance.largest.value * 1000.0);
  EXPECT_EQ(page.notes.front(),
            "Both motions are compared at every key of the input, in 8 places between two of them, and where they are "
            "farthest apart; a key shows the largest error up to the next. Between its keys the input is what its file "
            "says.");
}

}}  // namespace orispline
