// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>

#include "scenes/bvh_file.hpp"

namespace orispline::scenes { namespace {

using test::frames_of;
using test::scene_of;
using test::text_of;
using test::turn_about;
using test::turning;
using test::write_bvh;

using std::numbers::pi;

/// Whether no angle jumps, and all rotations are those that were meant.
void expect_continuous(const std::vector<Eigen::Quaterniond>& values, std::string_view order) {
  std::vector<double> times;
  for (std::size_t k = 0; k < values.size(); ++k) times.push_back(static_cast<double>(k));
  const SceneWriting writing{.euler = euler_order_of(order)};
  const std::string text = text_of(turning(times, values), writing);
  const auto frames = frames_of(text);
  const Scene again = scene_of(text);
  ASSERT_EQ(frames.size(), values.size());
  const auto from_lock = [&](std::size_t k) { return std::abs(std::remainder(frames[k][4] - 90.0, 180.0)); };
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_LT(angular_distance(again.clips[0].rotations[0].values[k], values[k]), 1e-13);
    if (k == 0 || from_lock(k) <= 1.0 || from_lock(k - 1) <= 1.0) continue;
    if (angular_distance(values[k - 1], values[k]) >= pi / 2) continue;
    for (std::size_t i = 3; i < 6; ++i)
      EXPECT_LT(std::abs(frames[k][i] - frames[k - 1][i]), 180.0) << order << " frame " << k << " angle " << i;
  }
}

TEST(BvhAngles, AnglesAreContinuousThroughManyTurnsAndThroughGimbalLock) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const std::string_view order : {"ZYX", "ZXY", "YXZ", "XYZ", "YZX", "XZY"}) {
    std::vector<Eigen::Quaterniond> tumbling{Eigen::Quaterniond::Identity()}, pitching;
    Eigen::Vector3d rate(0.3, 0.2, -0.1);
    for (int k = 0; k < 2000; ++k) {
      rate = 0.98 * rate + 0.05 * Eigen::Vector3d(normal(random), normal(random), normal(random));
      tumbling.push_back(tumbling.back() * exp<double>(Eigen::Vector3d(std::min(1.0, 1.5 / rate.norm()) * rate)));
    }
    expect_continuous(tumbling, order);
    // Straight through the lock, turn after turn: the middle angle goes on, the others stand.
    const int middle = order[1] - 'X';
    for (int k = 0; k < 300; ++k) pitching.push_back(turn_about(k * pi / 20, Eigen::Vector3d::Unit(middle)));
    expect_continuous(pitching, order);
    std::vector<double> times(pitching.size());
    for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<double>(k);
    const auto written = write_bvh(turning(times, pitching), {.euler = euler_order_of(order)});
    const auto frames = frames_of(written->bytes);
    EXPECT_NEAR(frames[299][4], 299 * 9.0, 1e-9) << order;
    EXPECT_NEAR(frames[299][3], 0.0, 1e-9);
    EXPECT_NEAR(frames[299][5], 0.0, 1e-9);
    ASSERT_EQ(written->warnings.size(), 1u);
    EXPECT_EQ(written->warnings[0].code, "gimbal_lock");
    EXPECT_EQ(written->warnings[0].number("frames"), 15.0);
  }
}

}}  // namespace orispline::scenes
