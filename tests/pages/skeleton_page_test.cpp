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
    EXPECT_EQ(page.notes.size(), 2U);
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
  EXPECT_EQ(page.notes.front(), "Both motions are compared at every key of the input.");
}

}}  // namespace orispline
