// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/wrong_runs.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/smooth/clip_smoothing.hpp>

namespace orispline { namespace {

constexpr std::size_t frames = 240;
constexpr double rate = 60.0, degree = std::numbers::pi / 180.0;

using Random = std::mt19937;

double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}
std::size_t one_of(Random& random, std::size_t count) { return random() % count; }
Eigen::Vector3d direction(Random& random) {
  Eigen::Vector3d v;
  do {
    for (double& x : v) x = between(random, -1, 1);
  } while (v.norm() > 1.0 || v.norm() < 0.1);
  return v.normalized();
}

/// Hips with a spine of two and an arm and a leg of three.
Skeleton figure() {
  return *Skeleton::make({{.name = "hips"},
                          {.name = "spine", .parent = 0},
                          {.name = "head", .parent = 1},
                          {.name = "arm", .parent = 1},
                          {.name = "forearm", .parent = 3},
                          {.name = "hand", .parent = 4},
                          {.name = "thigh", .parent = 0},
                          {.name = "shin", .parent = 6},
                          {.name = "foot", .parent = 7}});
}

/// Every joint swings about two axes, up to some 5° from frame to frame, with noise.
Clip motion(Random& random, double noise = 0.2 * degree) {
  Clip clip{.name = "walk"};
  std::normal_distribution<double> normal;
  for (std::size_t joint = 0; joint < figure().size(); ++joint) {
    RotationChannel& channel = clip.rotations.emplace_back(RotationChannel{.joint = joint});
    const Eigen::Vector3d one = direction(random), other = direction(random);
    const double pace = between(random, 0.5, 2.5), size = between(random, 0.1, 0.4), phase = between(random, 0, 6);
    for (std::size_t k = 0; k < frames; ++k) {
      const double t = static_cast<double>(k) / rate;
      const Eigen::Vector3d turn = size * std::sin(2 * std::numbers::pi * pace * t + phase) * one +
                                   0.5 * size * std::cos(2 * std::numbers::pi * 0.7 * pace * t) * other;
      const Eigen::Vector3d off = noise * Eigen::Vector3d(normal(random), normal(random), normal(random));
      channel.times.push_back(t);
      channel.values.push_back(exp<double>(turn) * exp<double>(off));
    }
  }
  return clip;
}

void turn(Clip& clip, std::size_t joint, std::size_t first, std::size_t count, const Eigen::Vector3d& by) {
  for (std::size_t k = first; k < first + count; ++k)
    clip.rotations[joint].values[k] = clip.rotations[joint].values[k] * exp<double>(by);
}

/// A joint and those below it.
std::vector<std::size_t> limb_of(std::size_t joint) {
  const Skeleton skeleton = figure();
  std::vector<std::size_t> limb{joint};
  for (std::size_t j = joint + 1; j < skeleton.size(); ++j)
    if (std::ranges::find(limb, skeleton[j].parent) != limb.end()) limb.push_back(j);
  return limb;
}

TEST(WrongRuns, AreNamedExactly) {
  Random random(11);
  int exact = 0;
  constexpr int runs = 200;
  for (int i = 0; i < runs; ++i) {
    Clip clip = motion(random);
    const std::size_t count = 3 + one_of(random, 22), first = 2 + one_of(random, frames - count - 3);
    const std::size_t joint = one_of(random, figure().size());
    const std::vector<std::size_t> joints = joint > 0 && one_of(random, 2) == 0 ? limb_of(joint) : std::vector{joint};
    const double angle = between(random, 10, 90) * degree;
    for (const std::size_t j : joints) turn(clip, j, first, count, angle * direction(random));
    const auto found = wrong_runs(figure(), clip);
    if (found.size() == 1 && found[0].joints == joints && found[0].first == first && found[0].count == count) ++exact;
  }
  EXPECT_GE(exact, runs * 95 / 100);
}

TEST(WrongRuns, AreNoneInAMotion) {
  Random random(12);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(wrong_runs(figure(), motion(random, i % 2 == 0 ? 0.0 : degree)).empty());
}

TEST(WrongRuns, AreNoneWhereAllJump) {
  Random random(13);
  Clip clip = motion(random);
  for (std::size_t joint = 0; joint < figure().size(); ++joint) turn(clip, joint, 100, 12, direction(random));
  EXPECT_TRUE(wrong_runs(figure(), clip).empty());
}

TEST(WrongRuns, AreNoneWhereAJointStaysAway) {
  Random random(14);
  Clip clip = motion(random);
  turn(clip, 4, 100, frames - 100, direction(random));
  EXPECT_TRUE(wrong_runs(figure(), clip).empty());
}

TEST(WrongRuns, AreNoneOfMoreFramesThanThat) {
  Random random(15);
  Clip clip = motion(random);
  turn(clip, 4, 100, longest_run + 1, direction(random));
  EXPECT_TRUE(wrong_runs(figure(), clip).empty());
}

TEST(WrongRuns, SwappedLimbsAndHoldsAreSome) {
  Random random(16);
  Clip swapped = motion(random, 0.0);
  for (std::size_t k = 60; k < 72; ++k)
    for (const std::size_t j : {3u, 4u, 5u}) {
      // The other limb is 50° away at least, and moves by itself.
      const Eigen::Quaterniond there = exp<double>({0.9 + 0.01 * static_cast<double>(k - 60), 0.3, 0.0});
      swapped.rotations[j].values[k] = swapped.rotations[j + 3].values[k] * there;
    }
  const auto of_swap = wrong_runs(figure(), swapped);
  ASSERT_EQ(of_swap.size(), 1u);
  EXPECT_EQ(of_swap[0].joints, (std::vector<std::size_t>{3, 4, 5}));
  EXPECT_EQ(of_swap[0].first, 60u);
  EXPECT_EQ(of_swap[0].count, 12u);
  EXPECT_EQ(of_swap[0].start, swapped.rotations[3].times[60]);
  EXPECT_EQ(of_swap[0].end, swapped.rotations[3].times[71]);
  EXPECT_GT(of_swap[0].jump, 0.5);

  Clip held = motion(random, 0.0);
  RotationChannel& channel = held.rotations[5];
  for (std::size_t k = 0; k < frames; ++k) channel.values[k] = exp<double>({0.03 * static_cast<double>(k), 0.0, 0.0});
  for (std::size_t k = 80; k < 90; ++k) channel.values[k] = channel.values[79];
  const auto of_hold = wrong_runs(figure(), held);
  ASSERT_EQ(of_hold.size(), 1u);
  EXPECT_EQ(of_hold[0].joints, std::vector<std::size_t>{5});
  EXPECT_EQ(of_hold[0].first, 80u);
  EXPECT_EQ(of_hold[0].count, 10u);
}

TEST(WrongRuns, AreBridgedBySmoothingUnlessNobodyWants) {
  Random random(17);
  const Clip clean = motion(random);
  Clip clip = clean;
  turn(clip, 4, 100, 12, {1.0, 0.0, 0.0});
  const auto farthest = [&](const ClipSmoothing& smoothing) {
    double largest = 0.0;
    for (std::size_t k = 100; k < 112; ++k)
      largest =
          std::max(largest, angular_distance(smoothing.clip.rotations[4].values[k], clean.rotations[4].values[k]));
    return largest;
  };
  const std::vector clips{clip};
  const auto bridged = smooth_clips(figure(), clips);
  ASSERT_TRUE(bridged) << bridged.error().message;
  ASSERT_EQ(bridged->front().runs.size(), 1u);
  EXPECT_LT(farthest(bridged->front()), 0.1);  // of 1 rad
  const auto kept = smooth_clips(figure(), clips, {.runs = false});
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->front().runs.empty());
  EXPECT_GT(farthest(kept->front()), 40.0 * degree);
}

}}  // namespace orispline
