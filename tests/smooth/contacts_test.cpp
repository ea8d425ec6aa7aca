// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/contacts.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/smooth/clip_smoothing.hpp>

namespace orispline { namespace {

constexpr double step_time = 1.0;  // of one foot [s]
constexpr double thigh = 0.45, shin = 0.45, pace = 0.6;

/// Hips, which go ahead, with two legs of two joints.
Skeleton walker() {
  const auto at = [](double x, double y, double z) { return JointPose{.translation = {x, y, z}}; };
  return *Skeleton::make({{.name = "hips"},
                          {.name = "thigh.l", .parent = 0, .rest = at(0.1, 0, 0)},
                          {.name = "shin.l", .parent = 1, .rest = at(0, -thigh, 0)},
                          {.name = "foot.l", .parent = 2, .rest = at(0, -shin, 0)},
                          {.name = "thigh.r", .parent = 0, .rest = at(-0.1, 0, 0)},
                          {.name = "shin.r", .parent = 4, .rest = at(0, -thigh, 0)},
                          {.name = "foot.r", .parent = 5, .rest = at(0, -shin, 0)}});
}

/// Where a foot is ahead of the hips, and how high: it stands for the first half of its step and swings in the other.
Eigen::Vector2d foot_at(double t) {
  const double s = std::fmod(t, step_time) / step_time, half = pace * step_time / 4;
  if (s < 0.5) return {half - pace * s * step_time, 0.0};
  const double u = 2 * s - 1;
  return {-half + (u - std::sin(2 * std::numbers::pi * u) / (2 * std::numbers::pi)) * 2 * half,
          0.1 * (1 - std::cos(2 * std::numbers::pi * u)) / 2};
}

/// The walk, each joint turned by an error that changes slowly.
Clip walk(double error) {
  Clip clip{.name = "walk"};
  std::vector<double> times;
  for (int k = 0; k < 240; ++k) times.push_back(k / 60.0);
  clip.translations.push_back({.joint = 0, .times = times});
  for (const double t : times) clip.translations[0].values.push_back({0, 0.8, pace * t});
  for (std::size_t side = 0; side < 2; ++side) {
    RotationChannel upper{.joint = 1 + 3 * side, .times = times}, lower{.joint = 2 + 3 * side, .times = times},
        foot{.joint = 3 + 3 * side, .times = times};
    for (const double t : times) {
      const Eigen::Vector2d ahead = foot_at(t + 0.5 * step_time * static_cast<double>(side));
      const double down = 0.8 - ahead.y(), length = std::hypot(ahead.x(), down);
      const double knee =
          std::numbers::pi - std::acos((thigh * thigh + shin * shin - length * length) / (2 * thigh * shin));
      const double hip = std::atan2(ahead.x(), down) + knee / 2;
      const auto about_x = [](double angle) { return exp<double>({angle, 0, 0}); };
      const auto off = [&](double phase) { return error * std::sin(9.0 * t + phase); };
      upper.values.push_back(about_x(-hip + off(1)));
      lower.values.push_back(about_x(knee + off(2)));
      foot.values.push_back(about_x(-knee + hip + off(3)));
    }
    for (RotationChannel* channel : {&upper, &lower, &foot}) clip.rotations.push_back(std::move(*channel));
  }
  return clip;
}

TEST(Contacts, OfAWalkAreHeldWhereTheFeetStand) {
  const Skeleton skeleton = walker();
  const Clip off = walk(0.02), truth = walk(0.0);
  const std::vector<std::string> legs{"auto"};
  const auto held = held_contacts(skeleton, off, legs);
  ASSERT_TRUE(held) << held.error().message;
  ASSERT_GE(held->contacts.size(), 8u);
  for (const Contact& contact : held->contacts) {
    EXPECT_TRUE(contact.joint == 3 || contact.joint == 6);
    EXPECT_GT(contact.slide_before, 0.04);
    EXPECT_LT(contact.slide_after, contact.slide_before / 6.0);  // about a seventh is meant to be left
  }
  double before = 0.0, after = 0.0, largest_step = 0.0;
  for (std::size_t i = 0; i < truth.rotations.size(); ++i)
    for (std::size_t k = 0; k < truth.rotations[i].size(); ++k) {
      const auto& right = truth.rotations[i].values[k];
      before += std::pow(angular_distance(off.rotations[i].values[k], right), 2);
      after += std::pow(angular_distance(held->clip.rotations[i].values[k], right), 2);
      if (k == 0) continue;
      const auto turn = [&](std::size_t key) {
        return off.rotations[i].values[key].conjugate() * held->clip.rotations[i].values[key];
      };
      largest_step = std::max(largest_step, angular_distance(turn(k - 1), turn(k)));
    }
  EXPECT_LE(after, before);
  EXPECT_LT(largest_step, 0.01);  // contacts come and go smoothly
}

TEST(Contacts, AreFoundInAWorldThatHasZUp) {
  Clip turned = walk(0.02);
  const Eigen::Quaterniond z_up = exp<double>({std::numbers::pi / 2, 0, 0});
  for (Eigen::Vector3d& place : turned.translations[0].values) place = z_up * place;
  const auto& times = turned.rotations[0].times;
  turned.rotations.push_back({.joint = 0, .times = times, .values = std::vector(times.size(), z_up)});
  const std::vector<std::string> legs{"auto"};
  const auto held = held_contacts(walker(), walk(0.02), legs), held_turned = held_contacts(walker(), turned, legs);
  ASSERT_TRUE(held && held_turned);
  ASSERT_EQ(held_turned->contacts.size(), held->contacts.size());
  for (std::size_t i = 0; i < held->contacts.size(); ++i) {
    EXPECT_EQ(held_turned->contacts[i].first, held->contacts[i].first);
    EXPECT_EQ(held_turned->contacts[i].count, held->contacts[i].count);
    EXPECT_NEAR(held_turned->contacts[i].slide_after, held->contacts[i].slide_after, 1e-9);
  }
}

TEST(Contacts, ThatStandAlreadyAreLeftAsTheyAre) {
  const Clip truth = walk(0.0);
  const auto held = held_contacts(walker(), truth, std::vector<std::string>{"foot.l", "foot.r"});
  ASSERT_TRUE(held);
  for (std::size_t i = 0; i < truth.rotations.size(); ++i)
    for (std::size_t k = 0; k < truth.rotations[i].size(); ++k)
      EXPECT_LT(angular_distance(held->clip.rotations[i].values[k], truth.rotations[i].values[k]), 0.03);
}

TEST(Contacts, WantJointsAtTheEndsOfLegs) {
  const auto fault = [](std::vector<std::string> names) {
    const auto held = held_contacts(walker(), walk(0.0), names);
    return held ? std::string() : held.error().option + ": " + held.error().message;
  };
  EXPECT_EQ(fault({"hoof"}), "keep_contacts: found no joint 'hoof', wanted names of the skeleton or auto");
  EXPECT_EQ(fault({"thigh.l"}),
            "keep_contacts: found joint 'thigh.l', which has no leg above it, wanted the end of a leg");
}

TEST(Contacts, AreHeldAfterSmoothing) {
  const std::vector clips{walk(0.01)};
  const auto smoothed = smooth_clips(walker(), clips, {.smoothing_time = 0.02, .keep_contacts = {"foot.l"}});
  ASSERT_TRUE(smoothed) << smoothed.error().message;
  ASSERT_GE(smoothed->front().contacts.size(), 4u);
  for (const Contact& contact : smoothed->front().contacts) EXPECT_EQ(contact.joint, 3u);
  EXPECT_TRUE(smooth_clips(walker(), clips, {.smoothing_time = 0.02})->front().contacts.empty());
}

}}  // namespace orispline
