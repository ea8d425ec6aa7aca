// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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

/// A joint that turns about z through 180°, as a tool wrote it.
std::string wrapped() {
  return test::one_joint("CHANNELS 3 Zrotation Xrotation Yrotation\n\tEnd Site\n\t{\n\t\tOFFSET 0 1 0\n\t}",
                         "170.125 10.5 20\n179.5 11.25 20.25\n-171.125 12 20.5\n-160.25 12.5 21\n", "Frames: 4\n");
}

TEST(BvhAngles, JumpsOfTheInputAreTakenOutWhereAnOrderIsAskedFor) {
  const Scene scene = scene_of(wrapped());
  EXPECT_EQ(frames_of(text_of(scene))[2][0], -171.125);
  const auto frames = frames_of(text_of(scene, {.euler = euler_order_of("ZXY")}));
  EXPECT_EQ(frames, (std::vector<std::vector<double>>{
                        {170.125, 10.5, 20}, {179.5, 11.25, 20.25}, {188.875, 12, 20.5}, {199.75, 12.5, 21}}));
}

/// How far turning each angle evenly from frame to frame leads from the straight way [°].
double detour_of(const std::vector<std::vector<double>>& frames, const EulerOrder& order) {
  double largest = 0.0;
  const auto made = [&](const std::vector<double>& from, const std::vector<double>& to, double share) {
    Eigen::Vector3d angles;
    for (std::size_t i = 0; i < 3; ++i)
      angles[static_cast<Eigen::Index>(i)] = (from[3 + i] + share * (to[3 + i] - from[3 + i])) * pi / 180;
    return quaternion_from_euler(order, angles);
  };
  for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
    const Eigen::Quaterniond start = made(frames[k], frames[k], 0), end = made(frames[k + 1], frames[k + 1], 0);
    for (double share = 0.05; share < 1.0; share += 0.05)
      largest = std::max(largest,
                         angular_distance(made(frames[k], frames[k + 1], share), start.slerp(share, end)) * 180 / pi);
  }
  return largest;
}

/// Steps of 10° that pass gimbal lock at this distance [rad].
Scene passing_the_lock(const EulerOrder& order, double distance) {
  const auto axis = [&](std::size_t turn) { return Eigen::Vector3d(Eigen::Vector3d::Unit(order.turns[turn])); };
  const Eigen::Quaterniond near = turn_about(pi / 2 - distance, axis(2).cross(axis(0)));
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> values;
  for (int k = 0; k < 16; ++k) {
    times.push_back(k / 32.0);
    values.push_back(turn_about((k - 7.7) * pi / 18, axis(2)) * near);
  }
  return turning(times, values);
}

TEST(BvhAngles, ADetourBetweenFramesIsSaidWithTheRateThatHoldsOneDegree) {
  const auto said_in = [](const SceneWritten& written) {
    const auto found = std::ranges::find(written.warnings, "euler_detour", &Warning::code);
    return found == written.warnings.end() ? nullptr : &*found;
  };
  for (const std::string_view name : {"ZYX", "ZXY", "YXZ", "XYZ", "YZX", "XZY"}) {
    const EulerOrder order = euler_order_of(name).value();
    const auto far = write_bvh(passing_the_lock(order, 0.7), {.euler = order});
    EXPECT_LE(detour_of(frames_of(far->bytes), order), 1.0);
    EXPECT_EQ(said_in(*far), nullptr);
    for (const double distance : {0.05, 0.1}) {
      const Scene scene = passing_the_lock(order, distance);
      const auto written = write_bvh(scene, {.euler = order});
      const Warning* const said = said_in(*written);
      ASSERT_NE(said, nullptr) << name << distance;
      EXPECT_NEAR(said->number("detour_deg"), detour_of(frames_of(written->bytes), order), 0.1);
      ASSERT_GT(said->number("rate_hz"), 32.0);
      const auto finer = write_bvh(scene, {.euler = order, .rate = said->number("rate_hz")});
      EXPECT_LE(detour_of(frames_of(finer->bytes), order), 1.0);
      EXPECT_EQ(said_in(*finer), nullptr);
    }
    // Nearly through the lock the angles go on as through it.
    const auto close = write_bvh(passing_the_lock(order, 1e-5), {.euler = order});
    EXPECT_LE(detour_of(frames_of(close->bytes), order), 1.0);
    EXPECT_EQ(said_in(*close), nullptr);
  }
}

}}  // namespace orispline::scenes
