// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/continuous_euler.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::Dice;
using testing_support::pi;

std::vector<EulerOrder> every_order() {
  std::vector<EulerOrder> orders;
  for (const std::string_view letters : {"XYZ", "xyz"})
    for (const char a : letters)
      for (const char b : letters)
        for (const char c : letters)
          if (const auto order = euler_order_of(std::string{a, b, c})) orders.push_back(*order);
  return orders;
}

double lock_of(const EulerOrder& order) { return order.is_proper() ? 0.0 : pi / 2; }

/// What a step of the angles may be, by the turn and by how far both ends are from the lock.
double longest_step(double turn, double lock, double next_lock) {
  const double both = lock + next_lock, between = (both - turn) / 2;
  const double near = std::sqrt((pi * pi + (turn + both) * (turn + both)) / 2 + both * both);
  return between > 0.0 ? std::min(near, turn / (std::numbers::sqrt2 * std::sin(between / 2))) : near;
}

void expect_continuous(const EulerOrder& order, const std::vector<Eigen::Quaterniond>& track) {
  const ContinuousEuler turns(order);
  const Eigen::Vector3d start = euler_angles(order, track.front());
  const auto whole = turns.over(track, start);
  ASSERT_EQ(whole.size(), track.size());
  Eigen::Vector3d row = start;
  for (std::size_t k = 0; k < track.size(); ++k) {
    const Eigen::Vector3d before = row;
    row = turns.after(before, track[k]);
    for (const Eigen::Vector3d& angles : {whole[k], row})
      EXPECT_LE(angular_distance(quaternion_from_euler(order, angles), track[k]), 1e-12);
    if (k == 0) continue;
    const double most = longest_step(angular_distance(track[k - 1], track[k]), turns.lock_distance(whole[k - 1]),
                                     turns.lock_distance(whole[k]));
    EXPECT_LE((whole[k] - whole[k - 1]).norm(), most * (1 + 1e-9) + 1e-12) << k;
    EXPECT_LE((row - before).norm(), most * (1 + 1e-9) + 1e-12) << k;
  }
}

TEST(ContinuousEuler, StepsAreAsShortAsTheTurnAndTheLockAllow) {
  Dice dice(5);
  for (const EulerOrder& order : every_order())
    for (int path = 0; path < 20; ++path) {
      std::vector<Eigen::Quaterniond> track{quaternion_from_euler(order, {dice.between(-pi, pi), 0.3, 1.0})};
      Eigen::Vector3d rate(0.1, -0.2, 0.05);
      const double size = dice.between(0.01, 0.6);
      for (int k = 0; k < 200; ++k) {
        rate = 0.95 * rate + Eigen::Vector3d(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)) * 0.3;
        track.push_back((track.back() * exp<double>(Eigen::Vector3d(size * rate))).normalized());
      }
      expect_continuous(order, track);
    }
}

TEST(ContinuousEuler, PathsThroughTheLockGoOn) {
  Dice dice(6);
  for (const EulerOrder& order : every_order())
    for (const int frames_at_lock : {0, 1, 2, 5}) {
      const double first = dice.between(-3, 3), third = dice.between(-3, 3), pace = dice.between(0.01, 0.1);
      std::vector<Eigen::Quaterniond> track;
      const auto add = [&](double second) { track.push_back(quaternion_from_euler(order, {first, second, third})); };
      for (int k = -20; k < 0; ++k) add(lock_of(order) + (k + 0.25) * pace);
      for (int k = 0; k < frames_at_lock; ++k) add(lock_of(order));
      for (int k = 1; k < 20; ++k) add(lock_of(order) + (k + 0.25) * pace);
      expect_continuous(order, track);
      const auto angles = ContinuousEuler(order).over(track, {first, lock_of(order) - 1, third});
      for (std::size_t k = 1; k < angles.size(); ++k) {
        EXPECT_LE((angles[k] - angles[k - 1]).norm(), 2.0 * pace + 1e-9) << k;
        EXPECT_NEAR(angles[k][0], first, 1e-9);
      }
    }
}

TEST(ContinuousEuler, WhatTheLockLeavesOpenGoesEvenlyToTheFrameBehind) {
  for (const EulerOrder& order : every_order()) {
    const double lock = lock_of(order);
    const Eigen::Vector3d before(0.2, lock - 0.1, 0.4);
    for (const int frames_at_lock : {1, 3}) {
      // Behind it the outer angles are 0.6 rad on, and what they make at the lock is the same.
      std::vector<Eigen::Quaterniond> track{quaternion_from_euler(order, before)};
      const Eigen::Quaterniond at = quaternion_from_euler(order, {0.2, lock, 0.4});
      for (int k = 0; k < frames_at_lock; ++k) track.push_back(at);
      const double sign = angular_distance(at, quaternion_from_euler(order, {0.8, lock, -0.2})) < 1e-9 ? -1.0 : 1.0;
      const Eigen::Vector3d behind(0.8, lock + 0.1, 0.4 + sign * 0.6);
      track.push_back(quaternion_from_euler(order, behind));
      expect_continuous(order, track);
      const auto angles = ContinuousEuler(order).over(track, before);
      EXPECT_NEAR((angles.back() - behind).norm(), 0.0, 1e-9);
      for (int k = 1; k <= frames_at_lock; ++k) {
        EXPECT_NEAR(angles[static_cast<std::size_t>(k)][0], 0.2 + 0.6 * k / (frames_at_lock + 1), 1e-9);
        EXPECT_NEAR(angles[static_cast<std::size_t>(k)][2], 0.4 + sign * 0.6 * k / (frames_at_lock + 1), 1e-9);
      }
      track.erase(track.begin());  // a track that begins at the lock has the angles of the frame behind
      EXPECT_NEAR(ContinuousEuler(order).over(track, before)[0][0], 0.8, 1e-9);
    }
  }
}

}}  // namespace orispline
